// Poisson disk (sphere) tile sets: tiles with points, of which every tiling is a Poisson disk distribution.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6. A tile set's points are stored
// whole, tile by tile, so that using it takes no knowledge of how it was made.
#pragma once

#include "base/word_table.hpp"
#include "tiles/poisson/classes/tile_classes.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// N is limited: tori are searched point by point.
inline constexpr std::uint32_t min_points_per_tile = 4;
inline constexpr std::uint32_t max_points_per_tile = 4096;

/// The highest order up to which tiles can be asked to have the same moments.
inline constexpr std::uint32_t max_moment_order = 3;

enum class PoissonTileKind : std::uint32_t
{
    corner = 0, ///< 2D, C^4 tiles by the colours of their corners (section 4.5); 3D, C^8 (section 4.6): "sphere"
    edge = 1,   ///< 2D, C^12 tiles by the colours of their edges and of those that stick out at corners (4.3)
    frame = 2,  ///< 2D, any number of tiles with the same points near their borders: template tiles (4.4)
};

/// The kinds of tiles by the words that users know.
struct PoissonTileFamily
{
    PoissonTileKind kind = PoissonTileKind::corner;
    int dimension = 2;

    bool operator==(const PoissonTileFamily&) const = default;
};
inline constexpr WordTable<PoissonTileFamily, 4> poisson_tile_families{{{
    {{PoissonTileKind::corner, 2}, "corner"},
    {{PoissonTileKind::edge, 2}, "edge"},
    {{PoissonTileKind::frame, 2}, "template"},
    {{PoissonTileKind::corner, 3}, "sphere"},
}}};

enum class TileFilling : std::uint32_t
{
    dart_throwing = 0,
    relaxation_dart_throwing = 1,
};
inline constexpr WordTable<TileFilling, 2> tile_fillings{
    {{{TileFilling::dart_throwing, "dart-throwing"},
      {TileFilling::relaxation_dart_throwing, "relaxation-dart-throwing"}}}};

/// The kinds of borders between tiles, whose points all of them share that have it.
enum class TileBorder : std::uint32_t
{
    strip = 0, ///< all points within a radius of an edge, and more of them at corners: regions, sections 4.3 to 4.6
    chain = 1, ///< a chain of points from corner to corner that no disk fits through: docs/chain-tiles.md
};
inline constexpr WordTable<TileBorder, 2> tile_borders{{{{TileBorder::strip, "strip"}, {TileBorder::chain, "chain"}}}};

/// All that a tile set is made from: the same parameters give the same tiles.
struct PoissonTileParameters
{
    PoissonTileKind kind = PoissonTileKind::corner;
    int dimension = 2;
    std::uint32_t colors = 0;          ///< C; template tiles: 1
    std::uint32_t tiles = 0;           ///< tile_count()
    std::uint32_t points_per_tile = 0; ///< N
    double relative_radius = 0;        ///< rho, of N points on the unit torus: dissertation, equations 4.3 and 4.6
    TileFilling filling = TileFilling::relaxation_dart_throwing;
    std::uint32_t attempts = 100; ///< failed darts in a row before the radius is reduced, or filling given up
    double factor = 0.99;         ///< that the radius is multiplied by; dart throwing: 1
    std::uint32_t lloyd_iterations = 0;
    bool repulsion = false;
    TileBorder border = TileBorder::strip;
    std::uint32_t joint_iterations = 0; ///< of relaxing all tiles together
    bool null_peaks = false;            ///< in these, the mean of all tiles is made even
    std::uint32_t equal_moments = 0;    ///< the order up to which all tiles have the same moments: docs/chain-tiles.md
    bool ranked = false;                ///< whether points have ranks, by which tilings get sparser
    TileClasses classes = {};           ///< none: all points are alike; set by set_classes()
    std::uint64_t seed = 1;

    bool operator==(const PoissonTileParameters&) const = default;
};

/// Plain dart throwing, given up after ten thousand failures in a row.
void set_dart_throwing(PoissonTileParameters& parameters);

/// Sets the border and what goes with it: for chains repulsion and, unless given, 20 joint iterations with nulling, the
/// best of what was measured in docs/chain-tiles.md; for strips nothing that is not given.
void set_border(PoissonTileParameters& parameters, TileBorder border,
                std::optional<std::uint32_t> joint_iterations = {}, std::optional<bool> null_peaks = {},
                std::optional<std::uint32_t> equal_moments = {});

/// Gives points classes, and sets what goes with them: N and rho are those of all points together, and points are
/// pushed apart, not relaxed.
void set_classes(PoissonTileParameters& parameters, TileClasses classes);

/// The order up to which equal moments are equal in whole numbers; those of higher orders that are asked for are so but
/// for rounding.
std::uint32_t exact_moment_order(const PoissonTileParameters& parameters);

/// The name of the tiles' kind, one of poisson_tile_families.
std::string kind_name(const PoissonTileParameters& parameters);

/// The number of tiles of a kind with so many colours, C^4, C^12 or C^8. 0: more than 2^32 - 1.
std::uint32_t tile_count(PoissonTileKind kind, int dimension, std::uint32_t colors);

/// The minimum distance that is asked for, 2 r, in units of the tile's side; with classes, the least of any two.
double asked_min_distance(const PoissonTileParameters& parameters);

/// A distance in tiles as whole squared units, rounded up: distances that are as large suffice.
std::uint64_t squared_units(double distance);

/// The asked minimum distance in whole units (of 1 / 65,536 of a tile's side), squared, rounded up: distances that
/// are as large suffice.
std::uint64_t asked_squared_distance(const PoissonTileParameters& parameters);

/// The regions that these tiles have: the radius, rounded up to whole units, is their width.
TileRegions regions_of(const PoissonTileParameters& parameters);

/// Throws InputError with the parameter's name as its key, and no place, for parameters that no tile set can
/// have: numbers out of range, sets that are too large, radii whose regions do not fit into a tile, and radii
/// at which the regions of neighbouring corners come closer than the minimum distance, so that corners would
/// have to suit each other.
void check(const PoissonTileParameters& parameters);

/// A point in units, relative to the lower corner of a tile or the base of a cell; 2D: z is 0.
using UnitPosition = std::array<std::int32_t, 3>;

/// The meaning of a stored coordinate: low + step times it, in units.
struct StoredScale
{
    std::int32_t low = 0;
    std::int32_t step = 1;

    std::int32_t position(std::uint16_t stored) const { return low + step * stored; }
};

/// Points of chains lie on both sides of an edge of their tile's square, up to half a tile outside of it.
inline StoredScale stored_scale(TileBorder border)
{
    return border == TileBorder::strip ? StoredScale{} : StoredScale{-tile_units / 2, 2};
}

struct PoissonTileSet
{
    PoissonTileParameters parameters;

    /// A proven lower bound of the squared distance of any two points of any tiling, in squared units; 0:
    /// none yet.
    std::uint64_t squared_min_distance = 0;

    /// Tile after tile, point after point, `dimension` coordinates each; see stored_scale(). With chains, a tile's
    /// points are that of its lower left corner, the chain along its lower edge from the left, that along its left edge
    /// from below, and those inside.
    std::vector<std::uint16_t> points;

    /// Borders that are chains: how many points each has between its corners. First those that go right, then those
    /// that go up, each by the colours of their lower and their upper end, the upper one counting fast.
    std::vector<std::uint16_t> chain_lengths = {};

    /// A proven lower bound of the squared distance of each pair of classes, in squared units, by class_pair(). Points
    /// of the first class come first in each tile, then those of the second, and so on.
    std::vector<std::uint64_t> class_squared_distances = {};

    /// The rank of each point in its tile, in the order of points: those of lower rank alone are spread evenly, too, in
    /// every tiling. Empty: the set is not ranked.
    std::vector<std::uint16_t> ranks = {};

    /// The coordinates of a tile's points as they are stored.
    std::span<const std::uint16_t> tile(std::uint32_t index) const
    {
        const std::size_t size =
            std::size_t{parameters.points_per_tile} * static_cast<std::size_t>(parameters.dimension);
        return {points.data() + index * size, size};
    }

    /// A point of a tile, relative to the tile's lower corner.
    UnitPosition position(std::uint32_t tile_index, std::uint32_t point) const
    {
        const StoredScale scale = stored_scale(parameters.border);
        const auto dimension = static_cast<std::size_t>(parameters.dimension);
        UnitPosition result{};
        for (std::size_t k = 0; k < dimension; ++k) result[k] = scale.position(tile(tile_index)[point * dimension + k]);
        return result;
    }

    bool operator==(const PoissonTileSet&) const = default;
};

/// The points of one class as a set of its own, whose points have no classes and no ranks. A tile may have fewer points
/// than check() allows, and its regions are those of the whole set.
PoissonTileSet class_subset(const PoissonTileSet& set, std::uint32_t of);

/// Throws InputError, a sentence that starts with the tile, unless the ranks of each tile's points are 0 to N - 1, each
/// once; or there are none, and the parameters say so.
void check_ranks(const PoissonTileSet& set);

/// The largest distance of points from their tile's square along any axis, in units.
struct Overhang
{
    std::int32_t below = 0;
    std::int32_t above = 0;

    bool operator==(const Overhang&) const = default;
};

Overhang overhang_of(const PoissonTileSet& set);

/// The relative radius of a squared distance in units: 0.75 where tilings are sure to have the minimum
/// distance of 0.75.
double relative_radius_of(std::uint64_t squared_distance, const PoissonTileParameters& parameters);

}
