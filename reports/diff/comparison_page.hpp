// A comparison of two results as a page of its own, diff.html, in the looks of the report.
#pragma once

#include "reports/diff/run_comparison.hpp"

#include <filesystem>

namespace poissonlab {

/// Writes out/diff.html, its style sheet, and plots of the radial curves that changed, old over new. Throws
/// StorageError.
void write_comparison_page(const RunComparison& comparison, const std::filesystem::path& before,
                           const std::filesystem::path& after, const std::filesystem::path& out);

}
