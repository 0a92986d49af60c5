#include "host/sampling/classics/sector_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/classics/scalloped_region.hpp"
#include "host/sampling/classics/torus_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

enum class SectorVariant
{
    logarithmic,
    linear,
    boundary,
};
constexpr WordTable<SectorVariant, 3> sector_variants{{{{SectorVariant::logarithmic, "logarithmic"},
                                                        {SectorVariant::linear, "linear"},
                                                        {SectorVariant::boundary, "boundary"}}}};

constexpr double units = 4294967296.0; ///< of the torus' side

/// The relative radius that full sets have, about.
double usual_radius(SectorVariant variant)
{
    return variant == SectorVariant::boundary ? 0.862 : variant == SectorVariant::linear ? 0.804 : 0.775;
}

/// Angles of a circle that are free, as ranges.
class FreeAngles
{
public:
    FreeAngles() : ranges_{{-std::numbers::pi, std::numbers::pi}} {}

    /// Angles are from -pi to pi: a range that reaches beyond comes in again at the other end.
    void subtract(double angle, double half)
    {
        const double begin = angle - half, end = angle + half;
        cut(begin, end);
        if (begin < -turn / 2) cut(begin + turn, end + turn);
        if (end > turn / 2) cut(begin - turn, end - turn);
    }

    bool is_empty() const { return ranges_.empty(); }

    /// A range by chance, whatever its length, and an angle in it.
    double choose(std::uint32_t random, double u) const
    {
        const Range& range = ranges_[std::uint64_t{random} * ranges_.size() >> 32];
        return range.begin + u * (range.end - range.begin);
    }

private:
    static constexpr double turn = 2 * std::numbers::pi;
    static constexpr double least = 1e-9;
    struct Range
    {
        double begin, end;
    };

    void cut(double begin, double end)
    {
        left_.clear();
        const auto keep = [&](double from, double to) {
            if (to - from > least) left_.push_back({from, to});
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

class SectorDarts
{
public:
    SectorDarts(double min_distance, const StreamKey& stream)
        : distance_(static_cast<std::uint64_t>(std::ceil(min_distance * units))),
          // Rounding a dart to the grid takes less than a unit from its distance.
          reach_(static_cast<double>(distance_ + 1)), stream_(stream),
          grid_(static_cast<std::size_t>(1 / (min_distance * min_distance)), 2)
    {
        const auto words = philox({0, 0, 0, first_use}, stream_);
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
    static constexpr std::uint32_t first_use = 0, choice_use = 1, dart_use = 2;

    std::array<std::uint32_t, 4> random(std::uint32_t use)
    {
        const std::uint64_t count = draws_++;
        return philox({static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(count >> 32), 0, use}, stream_);
    }

    static double uniform(std::uint32_t word) { return word / units; }

    PolarPlace seen_from(std::size_t from, std::size_t to) const
    {
        const double x = static_cast<std::int32_t>(grid_[to][0] - grid_[from][0]);
        const double y = static_cast<std::int32_t>(grid_[to][1] - grid_[from][1]);
        return {std::atan2(y, x), std::hypot(x, y)};
    }

    /// Adds a dart unless it is too near to a point, which rounding may make it.
    bool add(std::size_t from, const PolarPlace& place)
    {
        TorusPosition dart = grid_[from];
        dart[0] += static_cast<std::uint32_t>(std::llround(place.distance * std::cos(place.angle)));
        dart[1] += static_cast<std::uint32_t>(std::llround(place.distance * std::sin(place.angle)));
        if (grid_.squared_nearest(dart, distance_ * distance_ - 1) < distance_ * distance_) return false;
        grid_.add(dart);
        return true;
    }

    /// Random points are done one after the other: all darts that fit beside each.
    void grow_point_by_point(SectorVariant variant)
    {
        std::vector<std::size_t> open{0};
        while (!open.empty()) {
            const std::size_t chosen = std::uint64_t{random(choice_use)[0]} * open.size() >> 32;
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
        const auto subtract = [&](std::size_t other) {
            const PolarPlace place = seen_from(point, other);
            if (place.distance < 2 * reach_) free.subtract(place.angle, std::acos(place.distance / (2 * reach_)));
        };
        for (const std::size_t other : grid_.within(grid_[point], 2 * reach_))
            if (other != point) subtract(other);
        while (!free.is_empty()) {
            const auto words = random(dart_use);
            const double angle = free.choose(words[0], uniform(words[1]));
            if (add(point, {angle, reach_}))
                subtract(grid_.size() - 1);
            else
                free.subtract(angle, 1e-9); // rounded too near to a point: a sliver that holds none
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
            region.subtract(seen_from(point, other), other < point ? 2 * reach_ : reach_);
        }
        return region;
    }

    void fill_region(std::size_t point)
    {
        ScallopedRegion region = region_of(point);
        while (!region.is_empty()) {
            const auto words = random(dart_use);
            const PolarPlace place = region.sample(uniform(words[0]), uniform(words[1]));
            if (add(point, place))
                region.subtract(seen_from(point, grid_.size() - 1), reach_);
            else
                region.subtract(place, 1e-6 * reach_);
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
            const auto words = random(dart_use);
            std::size_t point = std::min(areas.find(uniform(words[2]) * areas.total()), regions.size() - 1);
            while (regions[point].is_empty()) point = (point + 1) % regions.size(); // what rounding leaves
            const PolarPlace place = regions[point].sample(uniform(words[0]), uniform(words[1]));
            if (!add(point, place)) {
                update(point, [&](ScallopedRegion& region) { region.subtract(place, 1e-6 * reach_); });
                continue;
            }
            const std::size_t added = grid_.size() - 1;
            for (const std::size_t other : grid_.within(grid_[added], 3 * reach_))
                if (other != added && !regions[other].is_empty())
                    update(other, [&](ScallopedRegion& region) { region.subtract(seen_from(other, added), reach_); });
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

double sector_distance(const Parameters& parameters, const SampleRequest& request)
{
    if (parameters.is_given("min_distance")) return parameters.number("min_distance");
    return min_distance_for(usual_radius(*sector_variants.find(parameters.text("variant"))), request.points, 2);
}

class SectorDartSampler final : public Sampler
{
public:
    SectorDartSampler(std::uint64_t seed, double min_distance, SectorVariant variant)
        : seed_(seed), distance_(min_distance), variant_(variant)
    {}

    bool sizes_vary() const override { return true; }

    PointSet sample(std::uint32_t realization) override
    {
        return SectorDarts(distance_, stream_key(seed_, Purpose::sector_darts, realization)).run(variant_);
    }

private:
    std::uint64_t seed_;
    double distance_;
    SectorVariant variant_;
};

}

SamplerSpec sector_dart_sampler()
{
    SamplerSpec spec =
        plain_spec("sector-darts", "Sector darts",
                   "darts beside the points that are there, until none fits (Dunbar and Humphreys 2006)", {2},
                   {{.key = "variant",
                     .kind = ParameterSpec::Kind::choice,
                     .help = "where the next dart falls: anywhere around points, by area; around one point after the "
                             "other; or at the least distance of one",
                     .choices = sector_variants.all(),
                     .otherwise = std::string(sector_variants[SectorVariant::boundary])},
                    {.key = "min_distance",
                     .help = "the minimum distance, in units of the torus' side",
                     .maximum = 0.125,
                     .exclusive_minimum = true,
                     .symbol = "d",
                     .unless_given = "what gives about analysis.points points"}});
    spec.check = [](const Parameters& parameters, const SampleRequest& request, const SourceLocation& where) {
        const double distance = sector_distance(parameters, request);
        if (distance > 0.125)
            throw InputError::at(where,
                                 fmt::format("sampler = \"sector-darts\": {} points have a distance of {:.3f}: must "
                                             "be at most 0.125, so that neighbourhoods do not meet themselves; more "
                                             "points",
                                             request.points, distance));
        constexpr double most = 1 << 26;
        if (1 / (distance * distance) > most)
            throw parameters.error("min_distance", fmt::format("must leave at most {:.0f} points", most));
    };
    spec.most_points = [](const Parameters& parameters, const SampleRequest& request) -> std::size_t {
        const double distance = sector_distance(parameters, request);
        return static_cast<std::size_t>(0.92 / (distance * distance)) + 20; // boundary darts have 0.86
    };
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<SectorDartSampler>(request.seed, sector_distance(parameters, request),
                                                   *sector_variants.find(parameters.text("variant")));
    };
    return spec;
}

}
