// The work of `poissonlab diff`.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

namespace poissonlab {

/// Compares two output folders or collections, and writes out/diff.html where `out` is not empty.
///
/// `format`: "table" (changes), "all" (every number), or "json". Returns whether something changed, and the text.
/// Throws InputError for folders without readable results.
std::pair<bool, std::string> compare_runs(const std::filesystem::path& before, const std::filesystem::path& after,
                                          const std::filesystem::path& out, const std::string& format);

}
