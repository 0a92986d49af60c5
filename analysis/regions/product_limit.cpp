#include "analysis/regions/product_limit.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace poissonlab {

std::vector<double> product_limit(std::vector<CensoredLength> lengths, double step, std::size_t count)
{
    // The ends of observations in order; of equal ones, those that end by their length come first.
    std::vector<std::pair<double, bool>> ends; // true: censored
    for (const CensoredLength& l : lengths) ends.emplace_back(std::min(l.length, l.seen), l.length > l.seen);
    std::ranges::sort(ends);
    std::vector<double> shares(count);
    double longer = 1;
    std::size_t i = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double up_to = step * static_cast<double>(k + 1);
        for (; i < ends.size() && ends[i].first <= up_to; ++i)
            if (!ends[i].second) {
                const auto left = static_cast<double>(ends.size() - i);
                longer *= (left - 1) / left;
            }
        shares[k] = 1 - longer;
    }
    return shares;
}

}
