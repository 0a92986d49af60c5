#include "host/tile_sampling/isohedral/isohedral_sampler.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "host/sampling/classics/plain_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::uint32_t most_failures = 10'000;
constexpr double random_deformation = 0.3;
constexpr double random_amplitude = 0.12;

/// Two numbers in [0, 1).
std::array<double, 2> fractions(const StreamKey& key, std::uint32_t number, std::uint32_t purpose)
{
    const auto words = philox({number, purpose, 0, 0}, key);
    return {words[0] * 0x1p-32, words[1] * 0x1p-32};
}

struct PlaneBox
{
    PlanePoint low{}, high{};
};

PlaneBox box_of(const std::vector<PlanePoint>& points)
{
    PlaneBox box{points.front(), points.front()};
    for (const PlanePoint& p : points)
        for (std::size_t i = 0; i < 2; ++i) {
            box.low[i] = std::min(box.low[i], p[i]);
            box.high[i] = std::max(box.high[i], p[i]);
        }
    return box;
}

/// True for points inside: a line to the right crosses the outline an odd number of times.
bool is_inside(const std::vector<PlanePoint>& outline, const PlanePoint& p)
{
    bool inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint &a = outline[i], &b = outline[(i + 1) % outline.size()];
        if ((a[1] > p[1]) == (b[1] > p[1])) continue;
        if (p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
}

double squared_distance(const PlanePoint& a, const PlanePoint& b)
{
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// An aspect of the tile and all tiles whose points may be near to its own.
struct Surroundings
{
    PlaneMotion home;
    std::vector<PlaneMotion> others; ///< without itself
};

std::vector<Surroundings> surroundings_of(const IsohedralTile& tile, double min_distance)
{
    std::vector<Surroundings> all;
    for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect) {
        const TilePlace place{aspect, 0, 0};
        Surroundings around{tile.motion(place), {}};
        std::vector<PlanePoint> moved;
        for (const PlanePoint& p : tile.outline()) moved.push_back(around.home(p));
        PlaneBox box = box_of(moved);
        for (std::size_t i = 0; i < 2; ++i) {
            box.low[i] -= min_distance;
            box.high[i] += min_distance;
        }
        for (const TilePlace& other : tile.tiles_near(box.low, box.high))
            if (other != place) around.others.push_back(tile.motion(other));
        all.push_back(std::move(around));
    }
    return all;
}

/// True if a point of the tile keeps its distance to those that are there, and to all copies of them and of itself.
bool fits(const PlanePoint& point, const std::vector<PlanePoint>& there, const std::vector<Surroundings>& surroundings,
          double squared)
{
    for (const PlanePoint& other : there)
        if (squared_distance(point, other) < squared) return false;
    for (const Surroundings& around : surroundings) {
        const PlanePoint here = around.home(point);
        for (const PlaneMotion& motion : around.others) {
            if (squared_distance(here, motion(point)) < squared) return false;
            for (const PlanePoint& other : there)
                if (squared_distance(here, motion(other)) < squared) return false;
        }
    }
    return true;
}

class IsohedralSampler final : public Sampler
{
public:
    IsohedralSampler(IsohedralTile tile, std::size_t points_per_tile, double relative_radius,
                     const SampleRequest& request)
        : tile_(std::move(tile)), points_per_tile_(points_per_tile), request_(request), area_(area_of(tile_.outline())),
          min_distance_(relative_radius * max_min_distance(points_per_tile, 2) * std::sqrt(area_))
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const auto repeated = repeated_points(tile_, points_per_tile_, min_distance_, request_.seed, realization);
        if (repeated.size() < points_per_tile_)
            throw InputError(fmt::format("isohedral-tiles: {} of {} points a tile fit at that radius; fewer, or a "
                                         "smaller relative_radius, may do",
                                         repeated.size(), points_per_tile_));
        PointSet set;
        // A window smaller than the room of a point may lie between points: then it lies elsewhere.
        for (std::uint32_t attempt = 0; set.size() == 0; ++attempt)
            set = window(repeated,
                         fractions(stream_key(request_.seed, Purpose::isohedral_points, realization, 1), attempt, 0));
        return set;
    }

    SetTraits traits() const override { return {.sizes_vary = true, .is_window = true}; }

private:
    /// The points in a square whose lowest corner is at these parts of both translations.
    PointSet window(const std::vector<PlanePoint>& repeated, const std::array<double, 2>& at) const
    {
        const double side =
            std::sqrt(static_cast<double>(request_.points) * area_ / static_cast<double>(points_per_tile_));
        const auto& [t1, t2] = tile_.translations();
        const auto [u, v] = at;
        const PlanePoint low{u * t1[0] + v * t2[0], u * t1[1] + v * t2[1]};
        PointSet set;
        for (const TilePlace& place : tile_.tiles_near(low, {low[0] + side, low[1] + side})) {
            const PlaneMotion motion = tile_.motion(place);
            for (const PlanePoint& point : repeated) {
                const PlanePoint moved = motion(point);
                const double x = (moved[0] - low[0]) / side, y = (moved[1] - low[1]) / side;
                if (x >= 0 && x < 1 && y >= 0 && y < 1) set.coordinates.insert(set.coordinates.end(), {x, y});
            }
        }
        return set;
    }

    IsohedralTile tile_;
    std::size_t points_per_tile_;
    SampleRequest request_;
    double area_;
    double min_distance_;
};

const IsohedralType& type_of(const Parameters& given)
{
    return isohedral_types()[static_cast<std::size_t>(given.integer("type") - 1)];
}

void check_isohedral(const Parameters& given, const SampleRequest&, const SourceLocation&)
{
    if (type_of(given).is_marked)
        throw given.error("type", fmt::format("IH{} needs markings, which points do not show", given.integer("type")));
}

std::unique_ptr<Sampler> create_isohedral(const Parameters& given, const SampleRequest& request, Engine,
                                          const DeviceProvider&)
{
    const IsohedralType& type = type_of(given);
    return std::make_unique<IsohedralSampler>(
        given.flag("random_shape") ? random_tile(type, request.seed, random_deformation, random_amplitude)
                                   : IsohedralTile(type, {}),
        static_cast<std::size_t>(given.integer("points_per_tile")), given.number("relative_radius"), request);
}

}

std::vector<PlanePoint> repeated_points(const IsohedralTile& tile, std::size_t count, double min_distance,
                                        std::uint64_t seed, std::uint32_t realization)
{
    const StreamKey key = stream_key(seed, Purpose::isohedral_points, realization);
    const std::vector<Surroundings> surroundings = surroundings_of(tile, min_distance);
    const PlaneBox box = box_of(tile.outline());
    const double squared = min_distance * min_distance;
    std::vector<PlanePoint> points;
    for (std::uint32_t dart = 0, failures = 0; points.size() < count && failures < most_failures; ++dart) {
        const auto [u, v] = fractions(key, dart, 1);
        const PlanePoint point{box.low[0] + u * (box.high[0] - box.low[0]),
                               box.low[1] + v * (box.high[1] - box.low[1])};
        if (!is_inside(tile.outline(), point)) continue;
        if (fits(point, points, surroundings, squared)) {
            points.push_back(point);
            failures = 0;
        } else {
            ++failures;
        }
    }
    return points;
}

SamplerSpec isohedral_tile_sampler()
{
    using Kind = ParameterSpec::Kind;
    SamplerSpec spec =
        plain_spec("isohedral-tiles", "Isohedral tiles",
                   "a window of an isohedral tiling that repeats the points of one tile: a negative example", {2},
                   {{.key = "type",
                     .kind = Kind::integer,
                     .help = "of the 93 types; 12 need markings and have no points of their own",
                     .minimum = 1,
                     .maximum = 93,
                     .symbol = "IH",
                     .otherwise = std::int64_t{28}},
                    {.key = "random_shape",
                     .kind = Kind::boolean,
                     .help = "a tile with random parameters and curves instead of the Laves tile",
                     .otherwise = false},
                    {.key = "points_per_tile",
                     .kind = Kind::integer,
                     .help = "that all tiles repeat",
                     .minimum = 1,
                     .maximum = 256,
                     .symbol = "n",
                     .otherwise = std::int64_t{32}},
                    {.key = "relative_radius",
                     .kind = Kind::number,
                     .help = "rho that the tiling has at least",
                     .maximum = 0.75,
                     .exclusive_minimum = true,
                     .symbol = "rho",
                     .otherwise = 0.65}});
    spec.check = check_isohedral;
    // A window cuts tiles: the number differs by about the points that a border of one tile's width has.
    spec.most_points = [](const Parameters&, const SampleRequest& request) -> std::size_t {
        return request.points + static_cast<std::size_t>(8 * std::sqrt(static_cast<double>(request.points))) + 512;
    };
    spec.create = create_isohedral;
    return spec;
}

}
