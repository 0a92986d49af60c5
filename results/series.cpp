#include "results/series.hpp"

#include "analysis/borders/border_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace poissonlab {

bool BorderResult::is_not_periodic() const { return chance < least_chance_across; }

std::string border_words(const Series& series)
{
    if (!series.border || !series.border->is_not_periodic()) return {};
    const BorderResult& border = *series.border;
    return fmt::format(
        "The closest pairs of points meet across the border ({} pairs are closer than any two inside): the "
        "sets are not periodic, and are measured as if they were. Without wrapping, the relative radius "
        "is {:.3f} and the mean nearest distance {:.3f}.",
        border.pairs_across, border.relative_radius, border.mean_nearest_distance);
}

std::string border_advice(int dimension)
{
    return fmt::format("To measure them within the {}: poissonlab analyze --periodic no; in a config {}; in Python "
                       "periodic=False. If they are periodic: --periodic yes, periodic=True.",
                       dimension == 2 ? "square" : "cube",
                       dimension == 2 ? "region = \"rectangle 0 0 1 1\" in the [[method]]"
                                      : "window = true under [analysis]");
}

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
