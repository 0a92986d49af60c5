#include "reports/layout/followed_density.hpp"

#include <algorithm>

namespace poissonlab {

bool follows_density(const ReportSeries& series)
{
    if (series.stored->region && series.stored->region->has_density) return true;
    return std::ranges::any_of(series.stored->parameters, [](const auto& parameter) {
        return is_followed_density(parameter.first, parameter.second);
    });
}

}
