// Filling tori of two tiles a side with points around those of pieces that are there already: the one step
// that all stages of the construction of Poisson tiles are made of.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6: dart throwing or relaxation dart
// throwing, then Lloyd relaxation with points that are held and movements that end at their regions, then
// repulsion. A batch of tori is filled at once.
#pragma once

#include "base/random/random.hpp"
#include "host/device/device.hpp"
#include "host/tile_construction/filling/tile_torus.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace poissonlab {

/// The class of a point, which is its third coordinate in the plane where points have classes; 0 where they have none.
inline std::uint32_t class_of(const TilePosition& point, const PoissonTileParameters& parameters)
{
    return parameters.classes.is_empty() ? 0 : static_cast<std::uint32_t>(point[2]);
}

/// The places into which darts are thrown: allowed cells, inside of a box.
struct DartZone
{
    CellSet cells = 0;
    std::int32_t low = 0;               ///< of the box, along each axis
    std::uint32_t extent = torus_units; ///< of the box
};

/// The settings that the tori of a batch have in common.
struct FillStage
{
    TileRegions regions;
    std::uint32_t number = 0;       ///< stages have their own random numbers
    bool is_one_tile = false;       ///< the torus has one tile a side; any image of a point stands for it
    DartZone active{};              ///< points move in these cells as well
    DartZone surroundings{};        ///< further points, so that active ones are not drawn into empty space
    bool surroundings_move = false; ///< in Lloyd relaxation; else they are held

    /// Active points lie inside of the polygon whose corners are the held points, in their order, instead of in cells.
    bool in_polygon = false;

    bool keep_tiles = false; ///< movements end in the tile that they start in

    /// Repulsion also gives the active points of the tile at (0, 0) the moments of their problem, up to this order.
    /// Tori that do not get these fail.
    std::uint32_t equal_moments = 0;
};

struct FillProblem
{
    std::vector<TilePosition> held;
    std::vector<TilePosition> given; ///< active points that are there already
    std::uint32_t active = 0;        ///< points that are wanted, those included
    std::uint32_t surroundings = 0;  ///< as many, or fewer where they do not fit
    std::uint32_t stream = 0;        ///< of random numbers

    /// The moments of active points, in units from the middle of the tile at (0, 0), as monomials_up_to() lists them.
    std::vector<std::int64_t> moments = {};

    /// The active points of each class, where points have classes.
    std::vector<std::uint32_t> classes = {};
};

struct FilledTorus
{
    std::vector<TilePosition> thrown; ///< active points as dart throwing left them; fewer than wanted: failed
    std::vector<TilePosition> active; ///< after relaxation and repulsion
    std::vector<TilePosition> thrown_surroundings;
    std::vector<TilePosition> surroundings; ///< after relaxation, where they move
    std::uint64_t squared_min_distance = 0; ///< of active points to all points, at most 2^32 - 1; 0: failed

    bool operator==(const FilledTorus&) const = default;
};

/// The settings of filling that all stages have in common.
struct FillSettings
{
    int dimension = 2;
    std::vector<std::uint32_t> squared_distances; ///< that darts keep, one after the other
    std::uint32_t attempts = 0;                   ///< failed darts in a row before the next
    std::uint32_t surrounding_attempts = 0;       ///< the same for surroundings, which need not be as good
    std::uint32_t lloyd_iterations = 0;
    std::uint32_t wanted = 0;           ///< squared minimum distance
    std::uint32_t repulsion_passes = 0; ///< at most; 0: no repulsion, and Lloyd relaxation is on its own
    double repulsion_distance = 0;      ///< closer points are pushed apart; units
    double spacing = 0;                 ///< mean distance of points: N^(-1/dimension) of a tile; units
    StreamKey stream{};
};

FillSettings fill_settings(const PoissonTileParameters& parameters);

class TileFiller
{
public:
    virtual ~TileFiller() = default;

    /// `attempt`: every one has its own random numbers.
    virtual std::vector<FilledTorus> fill(const FillStage& stage, std::span<const FillProblem> problems,
                                          std::uint32_t attempt) = 0;
};

namespace reference {
/// Sequentially, with Voronoi cells by CGAL.
std::unique_ptr<TileFiller> make_tile_filler(const FillSettings& settings);
}

/// A filler with the same results by kernels/tile_darts.cl and tile_relaxation.cl, a work-group a torus.
/// `work_group_size` 0: the default, at most 256.
std::unique_ptr<TileFiller> make_tile_filler(const FillSettings& settings, Device device,
                                             std::size_t work_group_size = 0);

/// The sizes of a stage's tori.
struct FillShape
{
    std::size_t tori;
    std::size_t points;     ///< of the fullest
    std::size_t moving;     ///< of them, of the one with the most
    std::size_t images = 1; ///< that are kept of each point
};

/// The memory that the filler takes on such a device for stages like these; large batches are cut to fit.
DeviceMemory filling_memory(const FillSettings& settings, std::span<const FillShape> stages, const DeviceInfo& device);

}
