#include "reports/diff/compare_runs.hpp"

#include "reports/diff/comparison_page.hpp"
#include "reports/diff/comparison_text.hpp"

namespace poissonlab {

std::pair<bool, std::string> compare_runs(const std::filesystem::path& before, const std::filesystem::path& after,
                                          const std::filesystem::path& out, const std::string& format)
{
    const auto comparison = compare_results(before, after);
    if (!out.empty()) write_comparison_page(comparison, before, after, out);
    return {comparison.changed(),
            format == "json" ? comparison_json(comparison) : comparison_table(comparison, format == "all")};
}

}
