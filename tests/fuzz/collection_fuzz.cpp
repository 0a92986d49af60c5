// Configs that include others by paths and globs. An input is several files: each begins with a line `#file NAME`, the
// first, the collection, does not need one.
#include "base/files/text_lines.hpp"
#include "experiment/config/collection.hpp"
#include "tests/fuzz/fuzz_support.hpp"

#include <algorithm>
#include <set>

namespace poissonlab::fuzz {
namespace {

constexpr std::string_view mark = "#file ";

/// Names of files of one folder: what leads out of it (also spelt as an escape) could be anything on this machine.
bool stays_inside(std::string_view text)
{
    return text.find_first_of("/\\") == std::string_view::npos && text.find("..") == std::string_view::npos;
}

bool is_name(std::string_view name)
{
    constexpr std::size_t longest = 20;
    return !name.empty() && name.size() <= longest && name.front() != '.' &&
           std::ranges::all_of(name, [](char c) { return (c >= 'a' && c <= 'z') || c == '.' || c == '[' || c == ']'; });
}

/// Writes the files of an input. Returns their names; the first is "all.toml".
std::set<std::string> write_files(std::string_view text)
{
    std::set<std::string> names;
    std::string name = "all.toml", content;
    const auto finish = [&] {
        if (names.insert(name).second) write_input(name, content);
        content.clear();
    };
    for (LineReader lines(text); lines.next();) {
        const std::string_view line = lines.line();
        if (line.starts_with(mark) && is_name(line.substr(mark.size()))) {
            finish();
            name = line.substr(mark.size());
        } else {
            content.append(line).append("\n");
        }
    }
    finish();
    return names;
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (!fuzz::stays_inside(text)) return 0;
    const auto names = fuzz::write_files(text);
    const auto file = fuzz::input_folder() / "all.toml";
    fuzz::accepts(fuzz::input_folder().native(), [&] {
        const ParsedConfig parsed = parse_file(file);
        if (is_collection(parsed)) fuzz::require(!read_collection(parsed).configs.empty(), "a collection of nothing");
    });
    for (const std::string& name : names) std::filesystem::remove(fuzz::input_folder() / name);
    return 0;
}
