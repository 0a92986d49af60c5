#include "results/series.hpp"

#include "analysis/borders/border_pairs.hpp"
#include "base/files/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
    return fmt::format(
        "To measure them without wrapping{}: poissonlab analyze --periodic no; in a config {}; in Python "
        "periodic=False. If they are periodic: --periodic yes, periodic=True.",
        dimension == 2 ? "" : ", which needs a cube",
        dimension == 2 ? "region = \"rectangle 0 0 1 1\" in the [[method]]" : "window = true under [analysis]");
}

/// The distance from a random point to the nearest other one has a standard deviation of 0.523 of its mean (Clark and
/// Evans 1954; 0.363 in space), and its mean over N points one of 0.523 / root N, or a little more as points share
/// distances. Methods that keep points apart vary less. A few percent are nothing to warn of, however large sets are.
std::string mixture_words(const Series& series)
{
    constexpr double random_deviation = 0.523, times_random = 4, least_told = 0.03;
    const auto found = series.measures.numbers.find("mean_nearest_distance");
    if (found == series.measures.numbers.end() || !found->second.standard_error) return {};
    const double deviation = *found->second.standard_error * std::sqrt(series.realizations) / found->second.value;
    const double random = random_deviation / std::sqrt(static_cast<double>(series.points));
    if (!(deviation > std::max(times_random * random, least_told))) return {};
    const auto percent = [](double part) {
        return part < 0.1 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
    };
    return fmt::format("The sets differ from each other more than sets of one method do: the standard deviation of "
                       "their mean nearest distances is {}; sets of random points have {}. If several "
                       "methods made them, analyze the sets of each method alone, or give each method a [[method]] "
                       "table in a config (sampler = \"file\"), so that the report compares them.",
                       percent(deviation), percent(random));
}

double BoxResult::unit_length() const { return root_of_volume(sides); }

PeriodicBox BoxResult::box() const { return periodic_box(sides); }

bool is_followed_density(const std::string& key, const std::string& text)
{
    double number = 0;
    return key == "density" && !parse_number(text, number);
}

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
