// The points of a tile set as they are stored, each once, however many tiles have it.
#pragma once

#include "host/tile_construction/joint/joint_relaxation.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

/// The numbers of the pieces that a tiling takes from a tile, not from its neighbours.
using OwnPieces = std::function<std::vector<std::size_t>(std::uint32_t tile)>;

/// A point that a tiling takes from a tile, as the moments of the tile have it.
struct OwnPoint
{
    std::uint32_t stored = 0;
    std::array<std::int8_t, 3> base{}; ///< where its piece is, in tiles from the tile
};
using OwnPoints = std::function<std::vector<OwnPoint>(std::uint32_t tile)>;

/// Pieces that tiles share, and the insides of tiles, with all their points in one list.
class StoredPoints
{
public:
    /// Adds a piece, whose points are relative to the lowest corner of the tiles that have it as their own. `weight`:
    /// the share of tiles that do. Returns its number.
    std::size_t add(std::span<const UnitPosition> points, double weight, bool moves);

    /// Adds a piece by points as mean_tile() has them.
    void add(std::span<const WeightedPoint> points);

    std::size_t count() const { return mean_tile_.size(); }
    std::size_t pieces() const { return first_.size() - 1; }

    /// The number of a piece's first point.
    std::size_t first(std::size_t piece) const { return first_[piece]; }

    /// The number after that of its last point.
    std::size_t end(std::size_t piece) const { return first_[piece + 1]; }

    /// All points, as the mean of all tiles has them.
    const std::vector<WeightedPoint>& mean_tile() const { return mean_tile_; }

    /// All copies on a torus. `tiles`: row after row from below, and layer after layer.
    JointTorus torus(int dimension, std::uint32_t side, std::span<const std::uint32_t> tiles,
                     const OwnPieces& own_pieces) const;

private:
    std::vector<std::size_t> first_{0}; ///< one more than there are pieces
    std::vector<WeightedPoint> mean_tile_;
};

/// The longest movement of nulling and of other corrections in a joint iteration, units.
double longest_joint_move(const PoissonTileParameters& parameters);

/// The movements of all stored points in a joint iteration: the mean of what Lloyd relaxation does to their copies on
/// that iteration's torus and, if asked for, nulling, and then a step to equal moments. Points with classes: for all
/// points together, and for those of each class.
std::vector<Displacement> joint_displacements(JointEngine& engine, const StoredPoints& points,
                                              const OwnPieces& own_pieces, const OwnPoints& own_points,
                                              const PoissonTileParameters& parameters, std::uint32_t iteration);

/// The movements of such an iteration without Lloyd relaxation: steps of nulling, which leave moments as they are.
std::vector<Displacement> evening_displacements(JointEngine& engine, const StoredPoints& points,
                                                const OwnPoints& own_points, const PoissonTileParameters& parameters);

}
