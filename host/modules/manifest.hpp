// The words of all modules, whichever a program has: a text that is written from a program with all of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

// The stored manifest as part of the binary.

/// The text of "manifest.tsv".
std::string_view manifest_file(std::string_view name);

/// The manifest lists words of four kinds.
enum class ManifestWord
{
    sampler,
    region_sampler,
    kind,
    command
};

struct ManifestEntry
{
    ManifestWord word{};
    std::string module;
    std::string name;      ///< of a kind: its table and its word, "distribution stippling"; of a command: "tiles build"
    std::string title;     ///< of samplers and kinds
    std::string summary;   ///< one line for the help
    std::string command{}; ///< of a kind
};

/// All entries, in the order in which help, messages and documentation list them.
const std::vector<ManifestEntry>& manifest();

/// The entries for the samplers and kinds of this program, each with its module.
std::vector<ManifestEntry> entries_of_laboratory();

/// Sorts entries as the manifest lists them; those that it does not know come last.
void sort_as_manifest(std::vector<ManifestEntry>& entries);

/// The text of a manifest: a line an entry.
std::string manifest_text(const std::vector<ManifestEntry>& entries);

}
