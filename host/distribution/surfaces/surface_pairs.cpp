// Cells are as wide as the points of one class are apart, about; points that see none within reach look again in cells
// that are twice as wide.
#include "host/distribution/surfaces/surface_pairs.hpp"

#include "host/distribution/surfaces/surface_neighbours.hpp"

#include <fmt/format.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace poissonlab {
namespace {

/// Points that see none within sixteen mean distances look on where these are no more pairs.
constexpr double many_pairs = 1e9;

}

SurfaceNearest surface_nearest(const FixedSurface& surface, const std::vector<SurfacePoint>& from,
                               const std::vector<SurfacePoint>& to, std::int32_t least_cosine)
{
    constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
    constexpr double farthest = 0x1p31; // units; the grid is less across
    std::vector<std::uint64_t> nearest(from.size(), none);
    std::vector<std::uint32_t> left(from.size());
    std::iota(left.begin(), left.end(), 0);
    const bool are_same = &from == &to;
    double reach = surface.units_of(std::sqrt(surface.area / static_cast<double>(std::max<std::size_t>(1, to.size()))));
    reach = std::clamp(reach, 16.0, farthest);
    const double wide = 16 * reach;
    for (; !left.empty() && !to.empty(); reach *= 2) {
        if (reach > wide && static_cast<double>(left.size()) * static_cast<double>(to.size()) > many_pairs) break;
        const double within = std::min(reach, farthest);
        const SurfaceNeighbours near(surface, to, static_cast<std::uint64_t>(within));
        const auto most = static_cast<std::uint64_t>(within) * static_cast<std::uint64_t>(within);
        tbb::parallel_for(std::size_t{0}, left.size(), [&](std::size_t k) {
            const std::uint32_t i = left[k];
            std::uint64_t least = none;
            near.for_each_around(place_of(from[i]), [&](std::size_t j) {
                if ((are_same && j == i) || cosine_between(surface.triangles[from[i].triangle],
                                                           surface.triangles[to[j].triangle]) < least_cosine)
                    return;
                least = std::min(least, squared_distance(place_of(from[i]), place_of(to[j])));
            });
            if (least <= most) nearest[i] = least;
        });
        std::erase_if(left, [&](std::uint32_t i) { return nearest[i] != none; });
        if (within == farthest) break;
    }
    SurfaceNearest result{INFINITY, 0};
    std::size_t seen = 0;
    for (const std::uint64_t squared : nearest) {
        if (squared == none) continue;
        const double distance = std::sqrt(static_cast<double>(squared)) * surface.unit;
        result.least = std::min(result.least, distance);
        result.mean += distance;
        ++seen;
    }
    result.mean = seen > 0 ? result.mean / static_cast<double>(seen) : NAN;
    return result;
}

std::vector<SurfacePair> surface_pairs(const FixedSurface& surface,
                                       const std::vector<std::vector<SurfacePoint>>& by_class,
                                       std::int32_t least_cosine)
{
    std::vector<SurfacePair> pairs;
    for (std::size_t i = 0; i < by_class.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const SurfaceNearest there = surface_nearest(surface, by_class[j], by_class[i], least_cosine);
            pairs.push_back(
                {j, i, there, i == j ? there : surface_nearest(surface, by_class[i], by_class[j], least_cosine)});
        }
    return pairs;
}

void append_pair_numbers(const std::vector<SurfacePair>& pairs, const std::vector<std::string>& names, bool are_along,
                         std::vector<DistributionNumber>& numbers)
{
    const auto add = [&](const std::string& key, const std::string& title, std::size_t from, std::size_t to,
                         double value, const std::string& meaning) {
        if (std::isfinite(value))
            numbers.push_back({fmt::format("{}_{}_{}", key, from, to),
                               fmt::format("{} {}, {}", title, names[from], names[to]),
                               value,
                               meaning + (are_along ? ", along the surface" : "") + ", in units of the mesh",
                               {},
                               true});
    };
    const std::string nearest = "mean_nearest", title = "Mean nearest distance",
                      meaning = "of points of the first class from their nearest ones of the second";
    for (const auto& [first, second, from_first, from_second] : pairs) {
        add("least", "Least distance", first, second, from_first.least,
            are_along ? "of two points" : "of points that see each other");
        add(nearest, title, first, second, from_first.mean, meaning);
        if (first != second) add(nearest, title, second, first, from_second.mean, meaning);
    }
}

DistributionTable pair_table(const std::vector<SurfacePair>& pairs, const std::vector<std::string>& names,
                             bool are_along)
{
    DistributionTable table{are_along ? "Nearest distances of classes, along the surface"
                                      : "Nearest distances of classes, straight through space",
                            {"classes", "least", "mean, from the first", "mean, from the second"},
                            {}};
    const auto shown = [](double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : "none"; };
    for (const auto& [first, second, from_first, from_second] : pairs)
        table.rows.push_back({fmt::format("{}, {}", names[first], names[second]), shown(from_first.least),
                              shown(from_first.mean), shown(from_second.mean)});
    return table;
}

}
