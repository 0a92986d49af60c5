#include "tiles/prototiles/periodic_tiling.hpp"

#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

/// The lattice of a tiling's periods.
class PeriodLattice
{
public:
    explicit PeriodLattice(const PolygonTiling& tiling) : tiling_(tiling)
    {
        const auto first = tiling.ring.value(tiling.period[0]), second = tiling.ring.value(tiling.period[1]);
        const double area = first[0] * second[1] - first[1] * second[0];
        to_periods_ = {second[1] / area, -second[0] / area, -first[1] / area, first[0] / area};
    }

    /// The number of periods that a place of the plane is away.
    std::array<double, 2> periods(const std::array<double, 2>& place) const
    {
        return {to_periods_[0] * place[0] + to_periods_[1] * place[1],
                to_periods_[2] * place[0] + to_periods_[3] * place[1]};
    }

    RingPlace vector(std::int64_t first, std::int64_t second) const
    {
        RingPlace sum;
        for (std::size_t i = 0; i < 4; ++i) sum.c[i] = first * tiling_.period[0].c[i] + second * tiling_.period[1].c[i];
        return sum;
    }

    /// The periods below a place. Places of one tiling that differ by periods get the same remainder: a place just
    /// below a period, by rounding, counts as on it.
    RingPlace below(const std::array<double, 2>& place) const
    {
        constexpr double rounding = 1e-7;
        const auto p = periods(place);
        return vector(static_cast<std::int64_t>(std::floor(p[0] + rounding)),
                      static_cast<std::int64_t>(std::floor(p[1] + rounding)));
    }

    /// A place of the ring without its periods.
    RingPlace remainder(const RingPlace& place) const { return place - below(tiling_.ring.value(place)); }

private:
    const PolygonTiling& tiling_;
    std::array<double, 4> to_periods_{};
};

/// A tile up to periods: its prototile, and its corners in order.
using RepeatedShape = std::pair<std::size_t, std::vector<RingPlace>>;

RepeatedShape repeated_shape(const PeriodLattice& lattice, const RootRing& ring, std::size_t prototile,
                             std::vector<RingPlace> corners)
{
    std::array<double, 2> middle{};
    for (const RingPlace& corner : corners)
        for (std::size_t axis = 0; axis < 2; ++axis)
            middle[axis] += ring.value(corner)[axis] / static_cast<double>(corners.size());
    const RingPlace below = lattice.below(middle);
    for (RingPlace& corner : corners) corner = corner - below;
    std::ranges::sort(corners);
    return {prototile, std::move(corners)};
}

/// Numbers that are joined into classes.
class JoinedNumbers
{
public:
    explicit JoinedNumbers(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0U); }

    void join(std::size_t a, std::size_t b) { parents_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

    std::size_t root(std::size_t number) const
    {
        while (parents_[number] != number) number = parents_[number];
        return number;
    }

    std::size_t classes() const
    {
        std::size_t count = 0;
        for (std::size_t i = 0; i < parents_.size(); ++i) count += parents_[i] == i;
        return count;
    }

private:
    std::vector<std::size_t> parents_;
};

/// Finds the symmetries of a tiling up to its periods, and what they exchange.
class SymmetrySearch
{
public:
    explicit SymmetrySearch(const PolygonTiling& tiling)
        : tiling_(tiling), lattice_(tiling), tiles_(tiling.unit.size()), vertices_(0)
    {
        for (std::size_t i = 0; i < tiling.unit.size(); ++i) {
            const std::vector<RingPlace> corners = corners_of(tiling, tiling.unit[i]);
            numbers_.emplace(repeated_shape(lattice_, tiling.ring, tiling.unit[i].prototile, corners), i);
            for (const RingPlace& corner : corners)
                vertex_numbers_.emplace(lattice_.remainder(corner), vertex_numbers_.size());
            corners_.push_back(corners);
        }
        vertices_ = JoinedNumbers(vertex_numbers_.size());
    }

    TransitivityClasses search()
    {
        for (int steps = 0; steps < tiling_.ring.order(); ++steps)
            for (const bool is_mirrored : {false, true}) try_linear_part({{}, tiling_.ring.unit(steps), is_mirrored});
        found_.tile_classes = tiles_.classes();
        found_.vertex_classes = vertices_.classes();
        std::map<std::size_t, std::size_t> class_of_root;
        for (std::size_t i = 0; i < corners_.size(); ++i)
            found_.tiles.push_back(class_of_root.emplace(tiles_.root(i), class_of_root.size()).first->second);
        return found_;
    }

private:
    /// Tries all motions with this turn or mirror that bring the first corner of the first tile to a corner, if it maps
    /// periods to periods.
    void try_linear_part(TileMotion motion)
    {
        for (const RingPlace& period : tiling_.period)
            if (lattice_.remainder(moved(tiling_.ring, motion, period)) != RingPlace{}) return;
        const RingPlace image = moved(tiling_.ring, motion, corners_[0][0]);
        std::set<RingPlace> places;
        for (const auto& [vertex, number] : vertex_numbers_) places.insert(lattice_.remainder(vertex - image));
        for (const RingPlace& place : places) {
            motion.at = place;
            try_motion(motion);
        }
    }

    void try_motion(const TileMotion& motion)
    {
        stop_if_interrupted();
        std::vector<std::size_t> images;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            std::vector<RingPlace> corners;
            for (const RingPlace& corner : corners_[i]) corners.push_back(moved(tiling_.ring, motion, corner));
            const auto found =
                numbers_.find(repeated_shape(lattice_, tiling_.ring, tiling_.unit[i].prototile, std::move(corners)));
            if (found == numbers_.end()) return;
            images.push_back(found->second);
        }
        ++found_.symmetries;
        found_.has_mirrors |= motion.is_mirrored;
        for (std::size_t i = 0; i < images.size(); ++i) tiles_.join(i, images[i]);
        for (const auto& [vertex, number] : vertex_numbers_)
            vertices_.join(number, vertex_numbers_.at(lattice_.remainder(moved(tiling_.ring, motion, vertex))));
    }

    const PolygonTiling& tiling_;
    PeriodLattice lattice_;
    std::vector<std::vector<RingPlace>> corners_;
    std::map<RepeatedShape, std::size_t> numbers_;
    std::map<RingPlace, std::size_t> vertex_numbers_;
    JoinedNumbers tiles_, vertices_;
    TransitivityClasses found_;
};

}

std::vector<RepeatedTile> repeated_tiles(const PolygonTiling& tiling, double x, double y)
{
    const PeriodLattice lattice(tiling);
    double reach = 0; // of the unit's corners from the origin
    for (const PlacedTile& tile : tiling.unit)
        for (const RingPlace& corner : corners_of(tiling, tile)) reach = std::max(reach, tiling.ring.sizes(corner)[0]);
    std::array<double, 2> most{};
    for (const double sign : {-1.0, 1.0}) {
        const auto periods = lattice.periods({x + reach, sign * (y + reach)});
        for (std::size_t i = 0; i < 2; ++i) most[i] = std::max(most[i], std::abs(periods[i]));
    }
    std::vector<RepeatedTile> tiles;
    for (auto first = -static_cast<std::int64_t>(most[0]) - 1; first <= static_cast<std::int64_t>(most[0]) + 1; ++first)
        for (auto second = -static_cast<std::int64_t>(most[1]) - 1; second <= static_cast<std::int64_t>(most[1]) + 1;
             ++second) {
            const RingPlace away = lattice.vector(first, second);
            const auto place = tiling.ring.value(away);
            if (std::abs(place[0]) > x + reach || std::abs(place[1]) > y + reach) continue;
            for (std::size_t i = 0; i < tiling.unit.size(); ++i) {
                PlacedTile tile = tiling.unit[i];
                tile.motion.at = tile.motion.at + away;
                tiles.push_back({i, tile});
            }
        }
    return tiles;
}

TransitivityClasses transitivity_classes(const PolygonTiling& tiling) { return SymmetrySearch(tiling).search(); }

bool unit_fills_period(const PolygonTiling& tiling)
{
    const RootRing& ring = tiling.ring;
    RingPlace tiles;
    for (const PlacedTile& tile : tiling.unit) tiles = tiles + quadruple_area(ring, corners_of(tiling, tile));
    const auto& [first, second] = tiling.period;
    return tiles == quadruple_area(ring, {RingPlace{}, first, first + second, second});
}

}
