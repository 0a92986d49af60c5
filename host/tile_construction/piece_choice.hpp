// The choice among candidates for a piece, by the numbers of points in their parts.
//
// A tile has as many points as any other, so what its corners, edges and faces have too many or too few goes
// to the expense of its interior. A piece's parts should therefore have the mean number of points; and those
// of the last stage before the interiors should make up for what the parts beside them miss of theirs: each
// part of an earlier piece shares what it misses equally among the last pieces that touch it in its tile. All
// pieces of a kind together should have the mean number as well, so that their regions are as dense as any
// other: what the pieces so far have too many counts against the next.
#pragma once

#include "host/tile_construction/boundary_stages.hpp"
#include "host/tile_construction/piece_store.hpp"
#include "host/tile_construction/tile_construction.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace poissonlab {

// The balance of a piece says how far its parts are from the number of points that they should have.

class PieceBalance
{
public:
    /// For tiles with `points` points each that count, all or those of a class. `pieces` has those of earlier stages
    /// and must, as the others, outlive this. `is_last`: next are the interiors.
    PieceBalance(std::uint32_t points, const PoissonTileParameters& parameters, const TileRegions& regions,
                 const PieceStore& pieces, bool is_last)
        : points_(points), parameters_(parameters), regions_(regions), pieces_(pieces), is_last_(is_last)
    {}

    /// The number of points that pieces with these axes have on average.
    double mean(std::uint8_t axes) const { return points_ * regions_.volume(axes); }

    /// The sum of the squares of what the tiles around would have too many points.
    double uneven(std::uint8_t axes, std::uint32_t variant, const PiecePoints& points) const;

private:
    double mean_in_part(std::uint8_t axes) const;

    /// The number of points that pieces of earlier stages lack in the tile at offset `tile`, as far as this piece is to
    /// make up for them.
    double carried(const std::vector<PlacedPiece>& neighbours, const std::array<int, 3>& tile) const;

    std::uint32_t points_;
    const PoissonTileParameters& parameters_;
    const TileRegions& regions_;
    const PieceStore& pieces_;
    bool is_last_;
};

class PieceChoice
{
public:
    /// `pieces` has those of earlier stages.
    PieceChoice(const PoissonTileParameters& parameters, const TileRegions& regions, const PieceStore& pieces,
                bool is_last);

    /// Notes all pieces that were made on a torus, if it has the wanted distance.
    void consider(const BoundaryTorus& torus, FillProblem problem, FilledTorus filled);

    /// Is there a candidate for every piece of this torus?
    bool has_all(const BoundaryTorus& torus) const;

    /// The largest squared distance of tori that failed.
    std::uint64_t best_failure() const { return best_failure_; }

    /// Puts the best candidates into the store, and tells of each.
    void take(PieceStore& pieces, const std::function<void(const ConstructionRecord&)>& record) const;

private:
    /// A torus that pieces can be taken from.
    struct Source
    {
        BoundaryTorus torus;
        FillProblem problem;
        FilledTorus filled;
    };

    struct Candidate
    {
        PiecePoints points;
        std::array<std::int8_t, 3> base{};
        std::shared_ptr<const Source> source;
    };

    const PoissonTileParameters& parameters_;
    const TileRegions& regions_;
    PieceBalance balance_;
    std::uint64_t wanted_;
    std::uint64_t best_failure_ = 0;
    std::map<std::pair<std::uint8_t, std::uint32_t>, std::vector<Candidate>> candidates_; ///< by axes and variant
};

}
