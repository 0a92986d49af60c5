// Sample elimination on surfaces, plain and sequential: what the kernels must reproduce.
#include "host/sampling/surfaces/surface_elimination.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab::reference {
namespace {

using contract::surface_elimination::Elimination;

std::uint64_t pair_weight(const Elimination& e, std::uint64_t squared)
{
    const double rest = 1 - std::max(std::sqrt(static_cast<double>(squared)), e.least) / e.reach;
    const double fourth = (rest * rest) * (rest * rest);
    return static_cast<std::uint64_t>(fourth * fourth * contract::surface_elimination::WEIGHT_UNITS + 0.5);
}

using PlainCells = std::map<MeshPlace, std::vector<std::uint32_t>>;

/// The numbers of points in the 27 cells around one.
std::vector<std::uint32_t> numbers_around(const PlainCells& cells, const MeshPlace& own)
{
    std::vector<std::uint32_t> numbers;
    for (int i = 0; i < 27; ++i) {
        const auto found = cells.find({own[0] + i % 3 - 1, own[1] + i / 3 % 3 - 1, own[2] + i / 9 - 1});
        if (found != cells.end()) numbers.insert(numbers.end(), found->second.begin(), found->second.end());
    }
    return numbers;
}

std::vector<std::vector<Partner>> surface_partners(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                                   const Elimination& e)
{
    const auto cell_of = [&](const SurfacePoint& p) {
        return MeshPlace{p.place[0] / e.cell, p.place[1] / e.cell, p.place[2] / e.cell};
    };
    PlainCells cells;
    for (std::uint32_t i = 0; i < points.size(); ++i) cells[cell_of(points[i])].push_back(i);
    std::vector<std::vector<Partner>> partners(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
        for (const std::uint32_t j : numbers_around(cells, cell_of(points[i]))) {
            const std::uint64_t squared = squared_distance(place_of(points[i]), place_of(points[j]));
            if (j != i && squared < e.squared_reach &&
                cosine_between(surface.triangles[points[i].triangle], surface.triangles[points[j].triangle]) >=
                    e.least_cosine)
                partners[i].push_back({j, pair_weight(e, squared)});
        }
    return partners;
}

}

std::vector<std::uint32_t> surface_removal_order(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                                 const SurfaceReach& reach, std::size_t count)
{
    return heaviest_first(surface_partners(surface, points, surface_elimination(surface, reach, points.size())), count,
                          {});
}

}
