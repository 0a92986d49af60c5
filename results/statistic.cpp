#include "results/statistic.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {

std::optional<Statistic> statistic_of(const std::vector<double>& each)
{
    if (each.empty() || !std::ranges::all_of(each, [](double value) { return std::isfinite(value); }))
        return std::nullopt;
    const auto [min, max] = std::ranges::minmax(each);
    return Statistic{min, std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size()), max, each};
}

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    const auto middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}
