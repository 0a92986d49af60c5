#include "tiles/poisson/poisson_tile_set.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

/// The most coordinates that the file of a tile set may hold: 4 GiB.
constexpr std::uint64_t max_coordinates = std::uint64_t{1} << 31;

/// The largest radius r, in tiles, at which regions fit, and neighbouring corner regions keep two radii of
/// distance.
double max_radius(const PoissonTileParameters& parameters)
{
    if (parameters.kind == PoissonTileKind::frame) return 0.25;
    // 1 - 2 reach >= 2 r: reach = (1 + sqrt 2) r for octagons, (1 + 2 sqrt 2) r for great rhombicuboctahedra.
    const double root = std::sqrt(2.0);
    return parameters.dimension == 2 ? 1 / (4 + 2 * root) : 1 / (4 + 4 * root);
}

/// The largest number of colours whose tiles can be counted.
std::uint32_t most_colors(PoissonTileKind kind, int dimension)
{
    if (kind == PoissonTileKind::frame) return 1;
    std::uint32_t colors = 1;
    while (tile_count(kind, dimension, colors + 1) != 0) ++colors;
    return colors;
}

/// The error about a parameter; who knows where it was set moves it there.
template <typename Value>
InputError refused(const char* key, const Value& value, const std::string& allowed)
{
    return invalid_value({}, key, fmt::format("{}", value), allowed);
}

/// Checks of parameters that are only for some borders, and of sets that chains are not for.
void check_border(const PoissonTileParameters& p)
{
    const bool has_chains = p.border == TileBorder::chain;
    if (p.joint_iterations > 100'000)
        throw refused("joint_iterations", p.joint_iterations, "must be an integer from 0 to 100000");
    if (p.equal_moments > max_moment_order)
        throw refused("equal_moments", p.equal_moments,
                      fmt::format("must be an integer from 0 to {}", max_moment_order));
    if (has_chains && (p.dimension != 2 || p.kind == PoissonTileKind::edge))
        throw refused("border", tile_borders[p.border], fmt::format("must be \"strip\" for {} tiles", kind_name(p)));
    if (has_chains && !p.repulsion) throw refused("repulsion", p.repulsion, "must be true for tiles with chains");
    if (p.null_peaks && p.joint_iterations == 0)
        throw refused("null_peaks", p.null_peaks, "must be false without joint iterations, which do it");
}

/// The relative radius follows from distances, which those who gave them know.
void check_room_of_classes(const PoissonTileParameters& p)
{
    check(p.classes, p.points_per_tile);
    if (relative_radius(p.classes.least_distance(), p.points_per_tile, p.dimension) >= 1)
        throw InputError(
            fmt::format("points of classes that keep a distance of {:.4f} tiles: {} in a tile have no room",
                        p.classes.least_distance(), p.points_per_tile));
}

/// Refuses what tiles with classes do not have.
void check_class_parameters(const PoissonTileParameters& p)
{
    if (p.dimension != 2)
        throw refused("class_points", fmt::format("{} classes", p.classes.count()), "tiles in the plane have classes");
    if (p.border != TileBorder::strip)
        throw refused("border", tile_borders[p.border], "must be \"strip\" for tiles with classes");
    if (p.lloyd_iterations != 0) throw refused("lloyd_iterations", p.lloyd_iterations, "must be 0 with classes");
    if (!p.repulsion) throw refused("repulsion", p.repulsion, "must be true for tiles with classes");
    const double radius = relative_radius(p.classes.least_distance(), p.points_per_tile, p.dimension);
    if (!(std::abs(p.relative_radius - radius) <= 1e-9))
        throw refused("relative_radius", p.relative_radius, fmt::format("must be {}, that of the classes", radius));
}

/// The largest distance that points of a set keep, in tiles: regions are half as wide.
double largest_distance(const PoissonTileParameters& p)
{
    return p.classes.is_empty() ? asked_min_distance(p) : p.classes.largest_distance();
}

void check_numbers(const PoissonTileParameters& p)
{
    if (p.dimension != 2 && !(p.dimension == 3 && p.kind == PoissonTileKind::corner))
        throw refused("dimension", p.dimension, fmt::format("{} tiles have no such dimension", kind_name(p)));
    const std::uint32_t most = most_colors(p.kind, p.dimension);
    if (p.colors < 1 || p.colors > most)
        throw refused("colors", p.colors,
                      fmt::format("must be {} for {} tiles",
                                  most == 1 ? "1" : fmt::format("an integer from 1 to {}", most), kind_name(p)));
    if (p.points_per_tile < min_points_per_tile || p.points_per_tile > max_points_per_tile)
        throw refused("points_per_tile", p.points_per_tile,
                      fmt::format("must be an integer from {} to {}", min_points_per_tile, max_points_per_tile));
    if (!p.classes.is_empty()) check_room_of_classes(p);
    if (!(p.relative_radius > 0 && p.relative_radius < 1))
        throw refused("relative_radius", p.relative_radius, "must be a number between 0 and 1");
    if (p.attempts < 1 || p.attempts > 1'000'000)
        throw refused("attempts", p.attempts, "must be an integer from 1 to 1000000");
    if (p.filling == TileFilling::relaxation_dart_throwing && !(p.factor > 0 && p.factor < 1))
        throw refused("factor", p.factor, "must be a number between 0 and 1");
    check_border(p);
    if (!p.classes.is_empty()) check_class_parameters(p);
}

/// Regions of neighbouring corners must not come closer than the largest distance. Template tiles whose points have
/// classes are made as corner tiles are.
void check_room(const PoissonTileParameters& p)
{
    if (!p.classes.is_empty()) {
        PoissonTileParameters corner = p;
        corner.kind = PoissonTileKind::corner;
        const double most = 2 * max_radius(corner);
        if (largest_distance(p) > most)
            throw InputError(
                fmt::format("points of classes that keep a distance of {:.4f} tiles: must be at most {:.4f}, "
                            "or points near neighbouring corners of a tile meet; more points per tile or a "
                            "smaller relative radius",
                            largest_distance(p), std::floor(most * 10'000) / 10'000));
        return;
    }
    const double limit = 2 * max_radius(p) / max_min_distance(p.points_per_tile, p.dimension);
    if (p.relative_radius > limit)
        throw refused("relative_radius", p.relative_radius,
                      fmt::format("must be at most {:.3f} with {} points per tile, or disks around neighbouring "
                                  "corners of a tile meet",
                                  std::floor(limit * 1000) / 1000, p.points_per_tile));
}

}

void set_dart_throwing(PoissonTileParameters& parameters)
{
    parameters.filling = TileFilling::dart_throwing;
    parameters.attempts = 10'000;
    parameters.factor = 1;
}

void set_border(PoissonTileParameters& p, TileBorder border, std::optional<std::uint32_t> joint_iterations,
                std::optional<bool> null_peaks, std::optional<std::uint32_t> equal_moments)
{
    constexpr std::uint32_t best_iterations = 20;
    const bool has_chains = border == TileBorder::chain;
    p.border = border;
    p.repulsion = p.repulsion || has_chains;
    p.joint_iterations = joint_iterations.value_or(has_chains ? best_iterations : 0);
    p.null_peaks = null_peaks.value_or(p.joint_iterations > 0);
    p.equal_moments = equal_moments.value_or(0);
}

void set_classes(PoissonTileParameters& p, TileClasses classes)
{
    p.points_per_tile = classes.all_points();
    p.relative_radius = relative_radius(classes.least_distance(), p.points_per_tile, p.dimension);
    p.lloyd_iterations = 0;
    p.repulsion = true;
    p.classes = std::move(classes);
}

std::uint32_t exact_moment_order(const PoissonTileParameters& p)
{
    return std::min(p.equal_moments, p.dimension == 2 ? 2U : 1U);
}

std::string kind_name(const PoissonTileParameters& parameters)
{
    const bool in_space = parameters.kind == PoissonTileKind::corner && parameters.dimension == 3;
    return poisson_tile_families[{parameters.kind, in_space ? 3 : 2}];
}

std::uint32_t tile_count(PoissonTileKind kind, int dimension, std::uint32_t colors)
{
    if (kind == PoissonTileKind::frame) return 1;
    const int digits = kind == PoissonTileKind::edge ? 12 : 1 << dimension;
    std::uint64_t count = 1;
    for (int digit = 0; digit < digits; ++digit) {
        count *= colors;
        if (count > UINT32_MAX) return 0;
    }
    return static_cast<std::uint32_t>(count);
}

double asked_min_distance(const PoissonTileParameters& parameters)
{
    return min_distance_for(parameters.relative_radius, parameters.points_per_tile, parameters.dimension);
}

std::uint64_t squared_units(double distance)
{
    const double units = distance * tile_units;
    return static_cast<std::uint64_t>(std::ceil(units * units));
}

std::uint64_t asked_squared_distance(const PoissonTileParameters& parameters)
{
    const TileClasses& classes = parameters.classes;
    return squared_units(classes.is_empty() ? asked_min_distance(parameters) : classes.least_distance());
}

TileRegions regions_of(const PoissonTileParameters& parameters)
{
    const auto width = static_cast<std::int32_t>(std::ceil(largest_distance(parameters) / 2 * tile_units));
    return parameters.kind == PoissonTileKind::frame ? frame_regions(width)
                                                     : modified_regions(parameters.dimension, width);
}

void check(const PoissonTileParameters& p)
{
    check_numbers(p);
    const std::uint64_t tiles = p.kind == PoissonTileKind::frame ? p.tiles : tile_count(p.kind, p.dimension, p.colors);
    if (tiles != p.tiles || tiles == 0)
        throw refused("tiles", p.tiles, "must be at least 1 and, but for template tiles, what the colours give");
    if (tiles * p.points_per_tile * static_cast<unsigned>(p.dimension) > max_coordinates)
        throw InputError(fmt::format("{} tiles of {} points: more than 4 GiB; fewer colours, tiles or points_per_tile",
                                     tiles, p.points_per_tile));
    check_room(p);
}

PoissonTileSet class_subset(const PoissonTileSet& set, std::uint32_t of)
{
    const TileClasses& classes = set.parameters.classes;
    PoissonTileSet subset{set.parameters, 0, {}};
    PoissonTileParameters& p = subset.parameters;
    p.points_per_tile = classes.points[of];
    p.relative_radius = relative_radius(classes.distances.at(of, of), p.points_per_tile, p.dimension);
    p.classes = {};
    p.ranked = false;
    const auto dimension = static_cast<std::size_t>(p.dimension);
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile) {
        const auto own = set.tile(tile).subspan(classes.first_point(of) * dimension, p.points_per_tile * dimension);
        subset.points.insert(subset.points.end(), own.begin(), own.end());
    }
    return subset;
}

void check_ranks(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    const std::size_t expected = p.ranked ? std::size_t{p.tiles} * p.points_per_tile : 0;
    if (set.ranks.size() != expected)
        throw InputError(fmt::format("{} ranks of points: must be {}", set.ranks.size(), expected));
    std::vector<bool> taken;
    for (std::size_t i = 0; i < expected; ++i) {
        const std::size_t tile = i / p.points_per_tile, point = i % p.points_per_tile;
        if (point == 0) taken.assign(p.points_per_tile, false);
        const std::uint16_t rank = set.ranks[i];
        if (rank >= p.points_per_tile)
            throw InputError(fmt::format("tile {}, point {}: rank {}: must be at most {}", tile, point, rank,
                                         p.points_per_tile - 1));
        if (taken[rank])
            throw InputError(
                fmt::format("tile {}, point {}: rank {}: another point of the tile has it", tile, point, rank));
        taken[rank] = true;
    }
}

Overhang overhang_of(const PoissonTileSet& set)
{
    if (set.parameters.border == TileBorder::strip || set.points.empty()) return {};
    const StoredScale scale = stored_scale(set.parameters.border);
    const auto [lowest, highest] = std::ranges::minmax(set.points);
    return {std::max(0, -scale.position(lowest)), std::max(0, scale.position(highest) - tile_units)};
}

double relative_radius_of(std::uint64_t squared_distance, const PoissonTileParameters& parameters)
{
    const double distance = std::sqrt(static_cast<double>(squared_distance)) / tile_units;
    return relative_radius(distance, parameters.points_per_tile, parameters.dimension);
}

}
