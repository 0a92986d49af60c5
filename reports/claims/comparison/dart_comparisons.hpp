// The claims about accelerated dart throwing compare radii and pictures with those of dart throwing.
#pragma once

#include "reports/claims/paper_claims.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace poissonlab {

/// The mean relative radius of each series, over the largest that dart throwing has in all realizations.
std::optional<ClaimOutcome> radii_beside(const std::vector<const ReportSeries*>& own,
                                         const std::vector<const ReportSeries*>& darts);

/// Errors of pictures of one set each, as a ratio: alike within 2 %, different beyond 5 %, by which sets of one method
/// do not differ.
std::optional<ClaimOutcome> plates_alike(const std::vector<std::pair<const ReportSeries*, const ReportSeries*>>& pairs);
inline constexpr auto plates_alike_criterion =
    "the root mean square errors of the zone plate differ by less than 2 %; open up to 5 %, as pictures are of one set "
    "each";

}
