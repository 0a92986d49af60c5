// Bringing back the minimum distance to tiles with strips after points were moved.
#pragma once

#include "host/tile_construction/joint/joint_relaxation.hpp"
#include "host/tile_construction/piece_store.hpp"
#include "host/tile_construction/tile_construction.hpp"

#include <compare>
#include <set>
#include <vector>

namespace poissonlab {

class MomentTargets;

/// Pushes the points of pieces apart, and gives pieces back to where they were where that fails.
class StripMender
{
public:
    using Tiles = std::vector<std::uint32_t>;

    /// `pieces` have the minimum distance now, and are what is gone back to.
    StripMender(StripPieces& pieces, const PoissonTileParameters& parameters, const JointEngines& engines,
                ConstructionReport& report);

    /// Brings back the minimum distance: borders first, then tiles between them.
    void mend();

    /// Pieces that cannot be pushed apart go back to where they were before, with those that they were made around.
    void mend_borders(const PieceStore& before);

    /// Pushes the points of tiles apart. Returns those that do not get the distance, which stay as they are.
    Tiles repel(const Tiles& open) { return fill_tiles(open, true, 0, nullptr); }

    /// Pushes the points of tiles apart that are there, or throws as many anew, so that tiles have the moments if any
    /// are asked for. Returns those that do not get the distance, which stay as they are.
    Tiles fill_tiles(const Tiles& open, bool are_given, std::uint32_t attempt, const MomentTargets* moments);

    Tiles all_tiles() const;

    /// The kinds of pieces that tiles share, in the order in which they were made.
    const std::vector<std::uint8_t>& border_axes() const { return border_axes_; }

    const TileRegions& regions() const { return regions_; }

private:
    /// A piece that tiles share.
    struct BorderPiece
    {
        std::uint8_t axes = 0;
        std::uint32_t variant = 0;

        auto operator<=>(const BorderPiece&) const = default;
    };
    using Borders = std::vector<BorderPiece>;
    using Back = std::set<BorderPiece>; ///< pieces that are as they were before

    void mend_borders(const PieceStore& before, Back& back);
    Borders repel_borders(const Back& back);
    Borders repel_frame(const Back& back);
    Tiles mend_tiles(const Back& back);
    FillProblem problem_around(const std::vector<PlacedPiece>& held, const PiecePoints& points,
                               std::uint32_t stream) const;
    bool is_good(const FillProblem& problem, const FilledTorus& filled) const;
    std::vector<std::size_t> fill(CellSet cells, const std::vector<FillProblem>& problems,
                                  const std::vector<PiecePoints*>& targets, std::uint32_t attempt,
                                  const MomentTargets* moments);

    const PoissonTileParameters& p_;
    StripPieces& pieces_;
    const StripPieces saved_;
    const JointEngines& engines_;
    ConstructionReport& report_;
    const TileRegions regions_;
    const std::uint64_t wanted_; ///< the squared distance
    std::vector<std::uint8_t> border_axes_;
};

/// The set of the one cell, around the lattice point at 0, of a kind of pieces.
CellSet cell_of_axes(std::uint8_t axes, int dimension);

}
