#include "host/sampling/varied/varied_elimination.hpp"

#include "host/sampling/classics/torus_grid.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "host/sampling/regions/region_candidates.hpp"
#include "kernels/common/optimized/sample_elimination.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint64_t most_failed_darts = 10'000'000;

TorusPoint<2> place_of(std::span<const double> point)
{
    return {static_cast<std::uint32_t>(point[0] * 0x1p32), static_cast<std::uint32_t>(point[1] * 0x1p32)};
}

/// The part of the torus below which cells around it would have many points each.
constexpr double least_part_of_torus = 1.0 / 256;

TorusGrid grid_for_varied(const FixedRegion& region, std::size_t points)
{
    const double positions = region.area() / (region.unit() * region.unit());
    if (positions > least_part_of_torus * 0x1p64) return {points, 2};
    const double width = std::sqrt(positions / static_cast<double>(points));
    return {points, 2, static_cast<std::uint64_t>(std::max(width, 1.0))};
}

/// The pairs of points that have a weight. Reaches are parts of the distances that pairs keep.
class VariedPartners
{
public:
    VariedPartners(const VariedDartRequest& request, const PointSet& points, const EliminationReach& reach)
        : request_(request), reach_(reach), grid_(grid_for_varied(*request.region, points.size()))
    {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const TorusPoint<2> place = place_of(points[i]);
            grid_.add({place[0], place[1], 0});
            distances_.push_back(request.field->at(place));
        }
        largest_ = std::ranges::max(distances_);
    }

    double distance(std::size_t i) const { return distances_[i]; }

    std::vector<std::vector<reference::Partner>> all() const
    {
        std::vector<std::vector<reference::Partner>> partners(grid_.size());
        tbb::parallel_for(std::size_t{0}, grid_.size(), [&](std::size_t i) {
            const double most = request_.is_mean ? (distances_[i] + largest_) / 2 : distances_[i];
            for (const std::size_t j : grid_.within(grid_[i], std::min(most * reach_.most, 0x1p31 - 1)))
                if (j != i) add_pair(i, j, partners[i]);
        });
        return partners;
    }

private:
    void add_pair(std::size_t i, std::size_t j, std::vector<reference::Partner>& to) const
    {
        const double kept =
            request_.is_mean ? (distances_[i] + distances_[j]) / 2 : std::min(distances_[i], distances_[j]);
        const double distance = std::sqrt(static_cast<double>(squared_torus_distance(grid_[i], grid_[j]))) / kept;
        if (!(distance < reach_.most)) return;
        const double rest = 1 - std::max(distance, reach_.least) / reach_.most;
        const double fourth = (rest * rest) * (rest * rest);
        to.push_back({static_cast<std::uint32_t>(j),
                      static_cast<std::uint64_t>(fourth * fourth * contract::sample_elimination::WEIGHT_UNITS + 0.5)});
    }

    const VariedDartRequest& request_;
    EliminationReach reach_;
    TorusGrid grid_;
    std::vector<double> distances_; ///< in positions
    double largest_ = 0;
};

}

VariedCandidates varied_candidates(const VariedDartRequest& request, std::size_t count)
{
    const VariedCells cells = first_varied_cells(request);
    VariedCandidates found;
    std::uint64_t thrown = 0, failed = 0;
    while (!cells.cells().empty() && found.points.size() < count && failed < most_failed_darts) {
        const auto dart = varied_dart(request, cells, 0, thrown++);
        failed = dart ? 0 : failed + 1;
        if (dart) found.points.push_back(dart->place);
    }
    found.share = thrown == 0 ? 0 : static_cast<double>(found.points.size()) / static_cast<double>(thrown);
    return found;
}

PointSet eliminate_varied(const VariedDartRequest& request, const std::vector<TorusPoint<2>>& points, std::size_t kept,
                          double packing)
{
    const RemovalOrder order = [&](const PointSet& left, const EliminationReach& reach, std::size_t count) {
        const VariedPartners partners(request, left, reach);
        const std::vector<std::uint32_t> factors =
            boundary_factors(*request.region, left, [&](std::size_t i) { return partners.distance(i) * reach.most; });
        return reference::heaviest_first(partners.all(), count, factors);
    };
    return eliminate(to_point_set<2>(std::span<const TorusPoint<2>>(points)), kept, order, packing);
}

}
