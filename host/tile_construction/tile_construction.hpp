// The construction of Poisson disk (sphere) tile sets, stage by stage.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007: edge-based tiles (section 4.3), template tiles (4.4),
// corner-based tiles (4.5), sphere tiles (4.6). Where this departs from it: all tori have two tiles a side,
// so that held pieces do not meet themselves; the wanted distance must be reached on all of a torus that
// corners and edges are cut from (or edges come out 4 to 6 % too sparse); of several candidates for a piece,
// that is taken whose number of points makes up best for what its neighbours have too much or too little, so
// that all tiles have as many points left for their interiors; a tile that cannot be filled gets a new
// edge (face, corner), together with all that have it; points that are still too close after relaxation may be
// pushed apart, sliding along the borders of their regions, and while they are, what surrounds them is held; without
// that, the last iterate is taken that has the wanted distance; of four masters of template tiles the one is taken
// whose strips come nearest to the number of points that they should have; and in space what surrounds an interior is
// filled three radii wide and held while the interior relaxes, where it is a whole torus that moves in the plane. Joint
// iterations, in which all tiles are relaxed together afterwards, are not of the dissertation; none are made unless
// asked for.
#pragma once

#include "host/tile_construction/filling/tile_filling.hpp"
#include "host/tile_construction/joint/joint_relaxation.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// The width of the filled surroundings of a tile in units. In the plane they are the rest of the torus; in space,
/// where that would be seven times as many points, three radii: the cells of the tile's own points end before.
inline std::int32_t surroundings_margin(const TileRegions& regions, int dimension)
{
    constexpr std::int32_t radii_in_space = 3;
    return dimension == 2 ? tile_units / 2 : std::min(tile_units / 2, radii_in_space * regions.width);
}

/// Masters of template tiles to choose from.
inline constexpr std::size_t master_tiles = 4;

/// A torus that was filled, for those who want to look.
struct ConstructionRecord
{
    std::uint8_t axes = 0; ///< of the piece that was made; all: the interior of a tile
    std::uint32_t variant = 0;
    std::array<std::int8_t, 3> base{}; ///< of its cell on the torus
    std::vector<PlacedPiece> held;
    const FillProblem* problem = nullptr;
    const FilledTorus* filled = nullptr;
};

struct ConstructionOptions
{
    /// Told how many of a stage's tori or tiles are done.
    std::function<void(const std::string& stage, std::size_t done, std::size_t total)> progress;

    /// Told of each torus that a piece, or a tile's interior, is taken from.
    std::function<void(const ConstructionRecord&)> record;
};

struct ConstructionReport
{
    std::size_t tori = 0;     ///< that were filled
    std::size_t failures = 0; ///< that did not reach the wanted distance
    std::size_t remade = 0;   ///< pieces that had to be made again because of a tile that could not be filled
};

struct ConstructedTileSet
{
    PoissonTileSet set; ///< not certified
    ConstructionReport report;
};

/// The engines that relax all tiles together.
struct JointEngines
{
    TileFiller& mender; ///< pushes apart what the iterations leave too close: see mending_settings()
    JointEngine& joint;
};

/// Says whether a set needs JointEngines: for joint iterations, or for equal moments.
inline bool are_relaxed_together(const PoissonTileParameters& p)
{
    return p.joint_iterations > 0 || p.equal_moments > 0;
}

/// Points are thrown and pushed apart, not relaxed one tile at a time.
FillSettings mending_settings(const PoissonTileParameters& parameters);

/// `together` is needed where are_relaxed_together(). Throws InputError for parameters that check() refuses, and
/// where a piece or a tile does not reach the wanted distance: which one, and what relative radius was reached.
ConstructedTileSet construct_tile_set(const PoissonTileParameters& parameters, TileFiller& filler,
                                      const ConstructionOptions& options = {}, const JointEngines* together = nullptr);

/// The memory that the torus of all tiles takes which joint iterations relax.
DeviceMemory joint_memory_of(const PoissonTileParameters& parameters);

/// The memory that the construction takes on such a device, nearly: chance decides how many points lie in a region.
DeviceMemory construction_memory(const PoissonTileParameters& parameters, const DeviceInfo& device);

}
