#include "reports/claims/comparison/dart_comparisons.hpp"

#include "reports/claims/claim_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

std::optional<ClaimOutcome> radii_beside(const std::vector<const ReportSeries*>& own,
                                         const std::vector<const ReportSeries*>& darts)
{
    constexpr double similar = 0.05;
    double largest = 0;
    for (const ReportSeries* series : darts)
        if (series->stored->relative_radius) largest = std::max(largest, series->stored->relative_radius->min);
    Cases cases;
    if (largest > 0)
        for (const ReportSeries* series : own) {
            const auto& radius = series->stored->relative_radius;
            if (!radius) continue;
            const Estimate ratio = ratio_of(mean_of_realizations(*radius), {largest, {}});
            cases.add(is_within(ratio, 1 - similar, 1 + similar),
                      fmt::format("{}: {}", series->label, format_fixed(radius->mean, 3)));
        }
    cases.say("dart throwing " + format_fixed(largest, 3));
    return cases.outcome();
}

std::optional<ClaimOutcome> plates_alike(const std::vector<std::pair<const ReportSeries*, const ReportSeries*>>& pairs)
{
    constexpr double alike = 0.02, different = 0.05;
    Cases cases;
    std::vector<double> ratios;
    for (const auto& [own, other] : pairs) {
        const double ours = plate_error(*own, 0, 1), theirs = plate_error(*other, 0, 1);
        if (ours == 0 || theirs == 0) continue;
        ratios.push_back(ours / theirs);
        const double off = std::abs(ratios.back() - 1);
        cases.add(off < alike ? Finding::holds : off < different ? Finding::open : Finding::fails);
    }
    return cases.outcome(range_words(ratios, 3));
}

}
