#include "host/sampling/regions/region_candidates.hpp"

#include "base/regions/fixed_edges.hpp"
#include "kernels/common/optimized/sample_elimination.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr std::uint64_t most_failures = 10'000'000, darts_for_share = 1'000'000;

constexpr std::size_t radii = 8, directions = 16, directions_in_space = 32;

/// Factors go no further: a point in a corner of 22 degrees has a sixteenth of its disk inside.
constexpr double most_factor = 16;

/// The part of the weight (1 - r)^8 over a disk of radius 1 that lies within r.
double weight_within(double r) { return 1 - std::pow(1 - r, 9) * (1 + 9 * r); }

/// The part of the weight (1 - r)^8 over a ball of radius 1 that lies within r.
double weight_within_ball(double r) { return 1 - std::pow(1 - r, 9) * (1 + 9 * r + 45 * r * r); }

/// Radii between which equal parts of a weight lie: the middle of each part.
std::array<double, radii> radii_of_equal_weight(double (*weight)(double))
{
    std::array<double, radii> result{};
    for (std::size_t i = 0; i < radii; ++i) {
        const double wanted = (static_cast<double>(i) + 0.5) / radii;
        double low = 0, high = 1;
        for (int step = 0; step < 40; ++step) {
            const double middle = (low + high) / 2;
            (weight(middle) < wanted ? low : high) = middle;
        }
        result[i] = low;
    }
    return result;
}

/// Tangents of half the angles of four directions in each quarter, evenly spread.
constexpr std::array<double, 4> half_tangents{0.0984914033571642, 0.303346683607342, 0.534511135950792,
                                              0.820678790828660};

/// Places in a disk of radius 1, with equal weights.
std::array<std::array<double, 2>, radii * directions> places_in_disk()
{
    std::array<std::array<double, 2>, radii * directions> places{};
    const std::array<double, radii> all = radii_of_equal_weight(weight_within);
    std::size_t next = 0;
    for (const double r : all)
        for (const double t : half_tangents) {
            const double x = r * (1 - t * t) / (1 + t * t), y = r * 2 * t / (1 + t * t);
            for (const std::array<double, 2>& place : {std::array{x, y}, {-y, x}, {-x, -y}, {y, -x}})
                places[next++] = place;
        }
    return places;
}

/// Places in a ball of radius 1, with equal weights: in the directions of the corners of an icosahedron and of the
/// middles of its faces, a dodecahedron's corners.
std::array<std::array<double, 3>, radii * directions_in_space> places_in_ball()
{
    const double golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<std::array<double, 3>> corners;
    for (const double s : {1.0, -1.0})
        for (const double t : {1.0, -1.0}) {
            for (const auto& [a, b] : {std::pair{s, t * golden}, std::pair{s / golden, t * golden}})
                for (const std::array<double, 3>& corner :
                     {std::array{0.0, a, b}, std::array{a, b, 0.0}, std::array{b, 0.0, a}})
                    corners.push_back(corner);
            for (const double u : {1.0, -1.0}) corners.push_back({s, t, u});
        }
    std::array<std::array<double, 3>, radii * directions_in_space> places{};
    std::size_t next = 0;
    for (const double r : radii_of_equal_weight(weight_within_ball))
        for (const auto& [x, y, z] : corners) {
            const double scale = r / std::sqrt(x * x + y * y + z * z);
            places[next++] = {x * scale, y * scale, z * scale};
        }
    return places;
}

template <std::size_t D>
TorusPoint<D> fixed_position(std::span<const double> point)
{
    TorusPoint<D> position;
    for (std::size_t k = 0; k < D; ++k) position[k] = static_cast<std::uint32_t>(point[k] * 0x1p32);
    return position;
}

template <typename Region>
using BoxOf = std::remove_cvref_t<decltype(std::declval<const Region&>().extent())>;

/// The box of positions within `reach` along each axis; nothing where it leaves the region's grid, unless `is_cut`.
template <typename Region>
std::optional<BoxOf<Region>> box_around(const PlaceIn<Region>& position, double reach, bool is_cut)
{
    BoxOf<Region> box;
    for (std::size_t k = 0; k < position.size(); ++k) {
        const double low = position[k] - reach, high = position[k] + reach;
        if (!is_cut && (low < 0 || high >= 0x1p31)) return {};
        box.low[k] = static_cast<std::uint32_t>(std::max(low, 0.0));
        box.high[k] = static_cast<std::uint32_t>(std::min(high, 0x1p31 - 1));
    }
    return box;
}

/// Tells which places around a position that is inside are inside as well. Where only a few edges cross the box around
/// them, the sides of these edges decide; otherwise each place is tested in the region.
class InsideAround
{
public:
    InsideAround(const FixedRegion& region, const TorusPoint<2>& position, double reach)
        : region_(region), is_simple_(region.find_crossing(*box_around<FixedRegion>(position, reach, true), edges_))
    {
        for (std::size_t i = 0; is_simple_ && i < edges_.size(); ++i) {
            const FixedEdge& e = edges_[i];
            const std::int64_t side = fixed_edges::line_side(e, position[0], position[1]);
            is_simple_ = side != 0;
            is_positive_[i] = side > 0;
            const double length = std::hypot(double{1} * e[2] - e[0], double{1} * e[3] - e[1]);
            nearest_ = std::min(nearest_, std::abs(static_cast<double>(side)) / length);
        }
    }

    /// Are all places inside that are so near to the position? (Places are rounded down.)
    bool contains_all_within(double distance) const { return is_simple_ && (distance + 2) * (1 + 1e-9) < nearest_; }

    bool contains(const TorusPoint<2>& place) const
    {
        if (!is_simple_) return region_.contains(place);
        bool is_inside = true;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const std::int64_t side = fixed_edges::line_side(edges_[i], place[0], place[1]);
            if (side == 0) return true;
            is_inside ^= is_positive_[i] != (side > 0);
        }
        return is_inside;
    }

private:
    const FixedRegion& region_;
    std::vector<FixedEdge> edges_;
    bool is_simple_;
    std::array<bool, FixedRegion::most_crossing + 1> is_positive_{};
    double nearest_ = std::numeric_limits<double>::infinity(); ///< of the edges' lines
};

/// Regions of space are asked one by one.
class InsideSpaceAround
{
public:
    InsideSpaceAround(const FixedSpace& space, const TorusPoint<3>& /*position*/, double /*reach*/) : space_(space) {}
    bool contains_all_within(double /*distance*/) const { return false; }
    bool contains(const TorusPoint<3>& place) const { return space_.contains(place); }

private:
    const FixedSpace& space_;
};

/// The distance of a place from the middle.
template <std::size_t D>
double distance_of(const std::array<double, D>& place)
{
    double squared = 0;
    for (const double c : place) squared += c * c;
    return std::sqrt(squared);
}

/// `places` in a disk or ball of radius 1 that have equal weights, from the nearest on. All points are inside.
template <typename Around, typename Region, typename Places>
std::vector<std::uint32_t> factors_by_places(const Region& region, const PointSet& points, const Places& places,
                                             const std::function<double(std::size_t)>& radius_of)
{
    using contract::sample_elimination::FACTOR_UNITS;
    std::vector<std::uint32_t> factors(points.size(), FACTOR_UNITS);
    std::array<double, std::tuple_size_v<Places>> distances{};
    std::ranges::transform(places, distances.begin(), [](const auto& place) { return distance_of(place); });
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
        const double radius = radius_of(i), reach = radius * distances.back() * (1 + 1e-9) + 1; // of all places
        const auto position = fixed_position<std::tuple_size_v<PlaceIn<Region>>>(points[i]);
        if (const auto box = box_around<Region>(position, reach, false))
            if (region.side_of(*box) == RegionSide::inside) return;
        const Around around(region, position, reach);
        std::size_t inside = 0;
        for (std::size_t j = 0; j < places.size(); ++j) {
            if (around.contains_all_within(radius * distances[j])) {
                ++inside;
                continue;
            }
            auto place = position;
            bool is_position = true;
            for (std::size_t k = 0; k < place.size(); ++k) {
                const double at = position[k] + places[j][k] * radius;
                is_position &= at >= 0 && at < 0x1p31;
                if (is_position) place[k] = static_cast<std::uint32_t>(at);
            }
            inside += is_position && around.contains(place);
        }
        const double factor = std::min(most_factor, static_cast<double>(places.size()) /
                                                        static_cast<double>(std::max<std::size_t>(inside, 1)));
        factors[i] = static_cast<std::uint32_t>(factor * static_cast<double>(FACTOR_UNITS) + 0.5);
    });
    return factors;
}

}

template <typename Region>
RegionCandidates<Region>::RegionCandidates(const Region& region, const StreamKey& stream, CandidateArea area,
                                           double least_share)
    : region_(region), stream_(stream), least_share_(least_share)
{
    if (area == CandidateArea::box) return;
    squares_ = std::make_shared<const RegionSquares<Region>>(squares_of(region, most_region_squares));
    area_part_ = static_cast<double>(squares_->corners.size());
    for (std::size_t k = 0; k < std::tuple_size_v<Place>; ++k)
        area_part_ *= std::exp2(squares_->shift) / (double{1} * region.extent().high[k] - region.extent().low[k] + 1);
}

template <typename Region>
PlaceIn<Region> RegionCandidates<Region>::dart(const std::array<std::uint32_t, 4>& words) const
{
    Place place;
    if (!squares_ || squares_->corners.empty()) {
        const auto& box = region_.extent();
        for (std::size_t k = 0; k < place.size(); ++k) {
            const std::uint64_t size = std::uint64_t{box.high[k]} - box.low[k] + 1;
            place[k] = box.low[k] + static_cast<std::uint32_t>(words[k] * size >> 32);
        }
        return place;
    }
    place = squares_->corners[words[3] * std::uint64_t{squares_->corners.size()} >> 32];
    for (std::size_t k = 0; k < place.size(); ++k) place[k] += squares_->within(words[k]);
    return place;
}

template <typename Region>
std::optional<PlaceIn<Region>> RegionCandidates<Region>::next()
{
    for (std::uint64_t failures = 0; failures < most_failures; ++failures) {
        const auto words =
            philox({static_cast<std::uint32_t>(thrown_), static_cast<std::uint32_t>(thrown_ >> 32), 0, 0}, stream_);
        ++thrown_;
        const Place place = dart(words);
        if (!region_.contains(place)) continue;
        ++found_;
        return place;
    }
    return {};
}

template <typename Region>
std::vector<PlaceIn<Region>> RegionCandidates<Region>::next(std::size_t count)
{
    std::vector<Place> places;
    places.reserve(count);
    while (places.size() < count) {
        if (thrown_ >= darts_for_share && share_of_darts() < least_share_) break;
        const std::optional<Place> place = next();
        if (!place) break;
        places.push_back(*place);
    }
    return places;
}

template class RegionCandidates<FixedRegion>;
template class RegionCandidates<FixedSpace>;

std::vector<std::uint32_t> boundary_factors(const FixedRegion& region, const PointSet& points,
                                            const EliminationReach& reach)
{
    return boundary_factors(region, points, [&](std::size_t) { return reach.most * 0x1p32; });
}

std::vector<std::uint32_t> boundary_factors(const FixedRegion& region, const PointSet& points,
                                            const std::function<double(std::size_t)>& radius_of)
{
    static const auto places = places_in_disk();
    return factors_by_places<InsideAround>(region, points, places, radius_of);
}

std::vector<std::uint32_t> boundary_factors(const FixedSpace& space, const PointSet& points,
                                            const EliminationReach& reach)
{
    static const auto places = places_in_ball();
    return factors_by_places<InsideSpaceAround>(space, points, places,
                                                [&](std::size_t) { return reach.most * 0x1p32; });
}

}
