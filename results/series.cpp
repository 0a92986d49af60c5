#include "results/series.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace poissonlab {

double BoxResult::unit_length() const { return root_of_volume(sides); }

PeriodicBox BoxResult::box() const { return periodic_box(sides); }

double spectrum_reach(const Series& series)
{
    const double half = series.spectrum_size / 2;
    return series.box ? half / series.box->box().longest() : half;
}

bool Series::is_repeated(std::size_t realization) const { return std::ranges::binary_search(repeated, realization); }

void Series::set_sizes(const std::vector<std::size_t>& sizes)
{
    const std::size_t count = sizes.size();
    const std::size_t total = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    realizations = static_cast<int>(count);
    points = count > 0 ? (total + count / 2) / count : 0;
    points_each.clear();
    if (std::ranges::adjacent_find(sizes, std::ranges::not_equal_to{}) != sizes.end()) points_each = sizes;
}

}
