// Sector darts, plain and sequential: what the kernels must reproduce.
#include "host/sampling/sectors/sector_darts.hpp"

#include "host/sampling/classics/torus_grid.hpp"
#include "host/sampling/reference/scalloped_region.hpp"
#include "kernels/common/sectors/sector_darts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab::reference {
namespace {

using namespace contract::sector_darts;
using contract::directions::direction_of;
using contract::directions::HALF_TURN;
using contract::directions::unit_vector;
using contract::directions::UnitVector;

/// Angles of a circle that are free, as ranges.
class FreeAngles
{
public:
    FreeAngles() : ranges_{{-HALF_TURN, HALF_TURN}} {}

    /// Angles are from -pi to pi: a range that reaches beyond comes in again at the other end.
    void subtract(double angle, double half)
    {
        const double begin = angle - half, end = angle + half;
        cut(begin, end);
        if (begin < -HALF_TURN) cut(begin + 2 * HALF_TURN, end + 2 * HALF_TURN);
        if (end > HALF_TURN) cut(begin - 2 * HALF_TURN, end - 2 * HALF_TURN);
    }

    bool is_empty() const { return ranges_.empty(); }

    /// A range by chance, whatever its length, and an angle in it.
    double choose(std::uint32_t random, double u) const
    {
        const Range& range = ranges_[std::uint64_t{random} * ranges_.size() >> 32];
        return range.begin + u * (range.end - range.begin);
    }

private:
    struct Range
    {
        double begin, end;
    };

    void cut(double begin, double end)
    {
        left_.clear();
        const auto keep = [&](double from, double to) {
            if (to - from > LEAST_ANGLE) left_.push_back({from, to});
        };
        for (const Range& range : ranges_) {
            if (end <= range.begin || begin >= range.end) {
                left_.push_back(range);
                continue;
            }
            keep(range.begin, begin);
            keep(end, range.end);
        }
        std::swap(ranges_, left_);
    }

    std::vector<Range> ranges_, left_; ///< the second one for the next cut
};

/// Sums of numbers of which one changes at a time, and the number at which a sum is reached (Fenwick).
class AreaTree
{
public:
    void set(std::size_t i, double area)
    {
        if (i >= areas_.size()) grow(i + 1);
        const double change = area - areas_[i];
        areas_[i] = area;
        for (std::size_t k = i + 1; k < sums_.size(); k += k & (~k + 1)) sums_[k] += change;
    }

    double operator[](std::size_t i) const { return areas_[i]; }

    double total() const
    {
        double sum = 0;
        for (std::size_t k = areas_.size(); k > 0; k &= k - 1) sum += sums_[k];
        return sum;
    }

    /// The first number whose sum with all before is larger.
    std::size_t find(double sum) const
    {
        std::size_t at = 0;
        for (std::size_t step = sums_.size() / 2; step > 0; step /= 2)
            if (at + step < sums_.size() && sums_[at + step] <= sum) {
                at += step;
                sum -= sums_[at];
            }
        return at;
    }

private:
    /// Sizes are powers of two, so that sums stay where they are; all are made anew, which takes away what rounding
    /// left.
    void grow(std::size_t size)
    {
        std::size_t capacity = 1;
        while (capacity < size) capacity *= 2;
        areas_.resize(capacity);
        sums_.assign(2 * capacity, 0);
        for (std::size_t i = 0; i < capacity; ++i)
            for (std::size_t k = i + 1; k < sums_.size(); k += k & (~k + 1)) sums_[k] += areas_[i];
    }

    std::vector<double> areas_, sums_;
};

class PlainSectorDarts
{
public:
    PlainSectorDarts(const SectorDartRequest& request, const StreamKey& stream)
        : distance_(sector_rules(request).distance), reach_(sector_rules(request).reach), stream_(stream),
          grid_(static_cast<std::size_t>(1 / (request.min_distance * request.min_distance)), 2)
    {
        const auto words = philox({0, 0, 0, FIRST_USE}, stream_);
        grid_.add({words[0], words[1], 0});
    }

    PointSet run(SectorVariant variant)
    {
        if (variant == SectorVariant::logarithmic)
            grow_by_area();
        else
            grow_point_by_point(variant);
        return grid_.point_set();
    }

private:
    std::array<std::uint32_t, 4> random(std::uint32_t use)
    {
        const std::uint64_t count = draws_++;
        return philox({static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(count >> 32), 0, use}, stream_);
    }

    static double uniform(std::uint32_t word) { return word / UNITS; }

    /// A point as seen from another one.
    std::array<double, 2> seen_from(std::size_t from, std::size_t to) const
    {
        return {static_cast<double>(static_cast<std::int32_t>(grid_[to][0] - grid_[from][0])),
                static_cast<double>(static_cast<std::int32_t>(grid_[to][1] - grid_[from][1]))};
    }

    void cut_off(ScallopedRegion& region, std::size_t point, std::size_t other, double radius) const
    {
        const auto [x, y] = seen_from(point, other);
        region.subtract(x, y, radius);
    }

    /// Cuts off the place of a rejected dart.
    void cut_off(ScallopedRegion& region, const PolarPlace& place) const
    {
        const UnitVector direction = unit_vector(place.angle);
        region.subtract(place.distance * direction.x, place.distance * direction.y, REJECTED_RADIUS * reach_);
    }

    static std::uint32_t rounded(double length)
    {
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(length + 0.5)));
    }

    /// Adds a dart unless it is too near to a point, which rounding may make it.
    bool add(std::size_t from, const PolarPlace& place)
    {
        const UnitVector direction = unit_vector(place.angle);
        TorusPosition dart = grid_[from];
        dart[0] += rounded(place.distance * direction.x);
        dart[1] += rounded(place.distance * direction.y);
        if (grid_.is_near(dart, distance_)) return false;
        grid_.add(dart);
        return true;
    }

    /// Random points are done one after the other: all darts that fit beside each.
    void grow_point_by_point(SectorVariant variant)
    {
        std::vector<std::size_t> open{0};
        while (!open.empty()) {
            const std::size_t chosen = std::uint64_t{random(CHOICE_USE)[0]} * open.size() >> 32;
            const std::size_t point = open[chosen];
            open[chosen] = open.back();
            open.pop_back();
            const std::size_t before = grid_.size();
            if (variant == SectorVariant::boundary)
                fill_boundary(point);
            else
                fill_region(point);
            for (std::size_t i = before; i < grid_.size(); ++i) open.push_back(i);
        }
    }

    void fill_boundary(std::size_t point)
    {
        FreeAngles free;
        // Half the angle that a point takes has the quotient of its distance and twice the reach as cosine.
        const auto reach = static_cast<std::uint64_t>(reach_);
        const auto subtract = [&](std::size_t other) {
            const std::uint64_t squared = squared_torus_distance(grid_[point], grid_[other]);
            if (squared >= 4 * reach * reach) return;
            const double across = std::sqrt(static_cast<double>(4 * reach * reach - squared));
            const auto [x, y] = seen_from(point, other);
            free.subtract(direction_of(x, y), direction_of(std::sqrt(static_cast<double>(squared)), across));
        };
        for (const std::size_t other : grid_.within(grid_[point], 2 * reach_))
            if (other != point) subtract(other);
        while (!free.is_empty()) {
            const auto words = random(DART_USE);
            const double angle = free.choose(words[0], uniform(words[1]));
            if (add(point, {angle, reach_}))
                subtract(grid_.size() - 1);
            else
                free.subtract(angle, REJECTED_ANGLE); // rounded too near to a point: a sliver that holds none
        }
    }

    /// The annulus around a point without the disks around others, and without what belongs to points before it.
    ScallopedRegion region_of(std::size_t point) const
    {
        // The points that take most come first: often nothing is left soon.
        std::vector<std::pair<double, std::size_t>> others;
        for (const std::size_t other : grid_.within(grid_[point], 4 * reach_)) {
            const double radius = other < point ? 2 * reach_ : reach_;
            const auto squared = static_cast<double>(squared_torus_distance(grid_[point], grid_[other]));
            if (other != point) others.emplace_back(std::sqrt(squared) - radius, other);
        }
        std::ranges::sort(others);
        ScallopedRegion region(reach_);
        for (const auto& [gap, other] : others) {
            if (region.is_empty() || gap >= 2 * reach_) break;
            cut_off(region, point, other, other < point ? 2 * reach_ : reach_);
        }
        return region;
    }

    void fill_region(std::size_t point)
    {
        ScallopedRegion region = region_of(point);
        while (!region.is_empty()) {
            const auto words = random(DART_USE);
            const PolarPlace place = region.sample(uniform(words[0]), uniform(words[1]));
            if (add(point, place))
                cut_off(region, point, grid_.size() - 1, reach_);
            else
                cut_off(region, place);
        }
    }

    /// Uniform in all regions.
    void grow_by_area()
    {
        std::vector<ScallopedRegion> regions{ScallopedRegion(reach_)};
        AreaTree areas;
        areas.set(0, regions[0].area());
        std::size_t open = 1; // regions that are not empty
        const auto update = [&](std::size_t i, const auto& change) {
            const bool was_open = !regions[i].is_empty();
            change(regions[i]);
            open -= was_open && regions[i].is_empty();
            areas.set(i, regions[i].area());
        };
        while (open > 0) {
            const auto words = random(DART_USE);
            std::size_t point = std::min(areas.find(uniform(words[2]) * areas.total()), regions.size() - 1);
            while (regions[point].is_empty()) point = (point + 1) % regions.size(); // what rounding leaves
            const PolarPlace place = regions[point].sample(uniform(words[0]), uniform(words[1]));
            if (!add(point, place)) {
                update(point, [&](ScallopedRegion& region) { cut_off(region, place); });
                continue;
            }
            const std::size_t added = grid_.size() - 1;
            for (const std::size_t other : grid_.within(grid_[added], 3 * reach_))
                if (other != added && !regions[other].is_empty())
                    update(other, [&](ScallopedRegion& region) { cut_off(region, other, added, reach_); });
            regions.push_back(region_of(added));
            areas.set(added, regions[added].area());
            open += !regions[added].is_empty();
        }
    }

    std::uint64_t distance_;
    double reach_; ///< of darts from the point they are thrown from, at least; units
    StreamKey stream_;
    TorusGrid grid_;
    std::uint64_t draws_ = 0;
};

}

PointSet throw_sector_darts(const SectorDartRequest& request, const StreamKey& stream)
{
    return PlainSectorDarts(request, stream).run(request.variant);
}

}
