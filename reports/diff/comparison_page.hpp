// A comparison of two results as a page of its own, diff.html, in the looks of the report.
#pragma once

#include "reports/diff/run_comparison.hpp"

#include <filesystem>
#include <string>
#include <utility>

namespace poissonlab {

// The work of `poissonlab diff`.

/// Compares two output folders or collections, and writes out/diff.html where `out` is not empty.
///
/// `format`: "table" (changes), "all" (every number), or "json". Returns whether something changed, and the text.
/// Throws InputError for folders without readable results.
std::pair<bool, std::string> compare_runs(const std::filesystem::path& before, const std::filesystem::path& after,
                                          const std::filesystem::path& out, const std::string& format);

/// Writes out/diff.html, its style sheet, and plots of the radial curves that changed, old over new. Throws
/// StorageError.
void write_comparison_page(const RunComparison& comparison, const std::filesystem::path& before,
                           const std::filesystem::path& after, const std::filesystem::path& out);

}
