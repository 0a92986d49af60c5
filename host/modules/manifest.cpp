#include "host/modules/manifest.hpp"

#include "base/word_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr WordTable<ManifestWord, 4> manifest_words{{{{ManifestWord::sampler, "sampler"},
                                                      {ManifestWord::region_sampler, "region-sampler"},
                                                      {ManifestWord::kind, "kind"},
                                                      {ManifestWord::command, "command"}}}};

/// The next field of a line, up to a tab or the end.
std::string next_field(std::string_view& line)
{
    const std::size_t end = std::min(line.find('\t'), line.size());
    const std::string field(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
    return field;
}

std::vector<ManifestEntry> parsed(std::string_view text)
{
    std::vector<ManifestEntry> entries;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == '#') continue;
        const auto word = manifest_words.find(next_field(line));
        if (!word) throw std::logic_error("the manifest of modules has a line of no known kind");
        ManifestEntry& entry = entries.emplace_back();
        entry.word = *word;
        entry.module = next_field(line);
        entry.name = next_field(line);
        entry.title = next_field(line);
        entry.summary = next_field(line);
        entry.command = next_field(line);
    }
    return entries;
}

}

const std::vector<ManifestEntry>& manifest()
{
    static const std::vector<ManifestEntry> entries = parsed(manifest_file("manifest.tsv"));
    return entries;
}

void sort_as_manifest(std::vector<ManifestEntry>& entries)
{
    std::ranges::stable_sort(entries, {}, [](const ManifestEntry& entry) {
        return std::ranges::find_if(
                   manifest(),
                   [&](const ManifestEntry& each) { return each.word == entry.word && each.name == entry.name; }) -
               manifest().begin();
    });
}

std::string manifest_text(const std::vector<ManifestEntry>& entries)
{
    std::string text = "# The words of all modules, written by `poissonlab manual --stored FOLDER`: what it is, the "
                       "module, the word, title, summary, command\n";
    for (const ManifestEntry& entry : entries)
        text += fmt::format("{}\t{}\t{}\t{}\t{}{}{}\n", manifest_words[entry.word], entry.module, entry.name,
                            entry.title, entry.summary, entry.command.empty() ? "" : "\t", entry.command);
    return text;
}

}
