// Relaxing all tiles of a set together, and making their mean even: docs/chain-tiles.md.
//
// A torus of tiles shows every tile several times, next to others. Each stored point moves by the mean of what Lloyd
// relaxation would do to its copies. Nulling moves stored points so that the transform of the mean tile, which every
// tiling shows at the frequencies of the lattice, becomes small.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/device.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <array>
#include <complex>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace poissonlab {

// The complex numbers of length 1 at whole parts of a turn, so that host and kernels multiply the same bits.

/// Whole cycles a tile along each axis; 2D: z is 0.
using TileFrequency = std::array<std::int32_t, 3>;

/// exp(-2 pi i n / 65,536) for n from 0 to 65,535: what a point n units along an axis adds to the lowest frequency.
const std::vector<std::complex<double>>& unit_circle();

/// The entry for a frequency (cycles a tile) and a position.
inline std::uint32_t phase_of(const TileFrequency& frequency, const TilePosition& position)
{
    std::uint32_t phase = 0;
    for (std::size_t k = 0; k < 3; ++k)
        phase += static_cast<std::uint32_t>(frequency[k]) * static_cast<std::uint32_t>(position[k]);
    return phase & (tile_units - 1);
}

/// A movement in units; 2D: z is 0.
using Displacement = std::array<double, 3>;

/// A copy of a stored point on a torus of tiles.
struct PointCopy
{
    std::uint32_t stored = 0;
    UnitPosition position{}; ///< from 0 to the torus' side
};

/// All copies on a torus of `side` tiles a side.
struct JointTorus
{
    int dimension = 2;
    std::uint32_t side = 0;
    std::vector<PointCopy> copies;
};

/// A stored point as the mean tile has it.
struct WeightedPoint
{
    UnitPosition position{};
    double weight = 0; ///< the share of tiles that have it
    bool moves = true;
};

/// The two computations that take the time, by kernels or sequentially; the results are the same but where a Voronoi
/// cell's centroid is rounded.
class JointEngine
{
public:
    virtual ~JointEngine() = default;

    /// The displacement from each copy to the centroid of its Voronoi cell, as a part of the torus.
    virtual std::vector<double> centroid_displacements(const PointSet& points) = 0;

    /// The mean displacement of each stored point's copies, in their order; 0 without any.
    std::vector<Displacement> mean_displacements(const JointTorus& torus, std::size_t stored);

    /// Moves that lower the power of the mean tile at some frequencies: a step of gradient descent, at most `longest`
    /// units. Points that do not move count, but get none.
    virtual std::vector<Displacement> nulling_displacements(std::span<const WeightedPoint> points,
                                                            std::span<const TileFrequency> frequencies,
                                                            double longest) = 0;
};

/// The memory that the engine takes on a device, with so many copies on its tori and so many stored points.
DeviceMemory joint_memory(int dimension, std::size_t copies, std::size_t stored, std::uint32_t points_per_tile);

/// Nulling reaches frequencies up to so many square (cube) roots of the points a tile: with less, power beyond grows.
inline constexpr double nulling_reach = 2;

/// Frequencies up to so many square (cube) roots of the points a tile, one of each two opposite ones.
std::vector<TileFrequency> nulled_frequencies(std::uint32_t points_per_tile, int dimension,
                                              double reach = nulling_reach);

/// The step of nulling, over pi times the sum of squared weights of what moves.
double nulling_step(std::span<const WeightedPoint> points);

namespace reference {
std::unique_ptr<JointEngine> make_joint_engine(int dimension);
}

/// Makes an engine that relaxes by the Voronoi kernels and joint_nulling.cl.
std::unique_ptr<JointEngine> make_joint_engine(int dimension, Device device, std::size_t work_group_size = 0);

}
