// The pieces of triangles on which darts fall: those that may be uncovered, chosen by their areas.
//
// Cline, Jeschke, White, Razdan, Wonka, Dart throwing on surfaces, EGSR 2009. Their fragments are divided into four;
// here a piece is halved across its longest edge, so that long triangles become wide pieces. Corners are shares of the
// triangle's corners in units of 2^-31, and halves are exact. A piece is last when its edges have no more than LIMIT
// units, or halves would not be exact.
#pragma once

#include "analysis/spectra/uninitialized_vector.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

using SurfacePiece = contract::surface::Piece;

/// A table that leads random numbers to pieces: weights are areas in whole numbers, whose sum is 2^62 or a little less,
/// so that a piece's share is wrong by 2^-62 at most, and each has one at least.
struct SurfacePieceChoice
{
    UninitializedVector<std::uint64_t> ends;  ///< of each piece: the sum of weights up to it
    UninitializedVector<std::uint32_t> guide; ///< the first piece that random words with these upper bits can lead to
    std::uint32_t guide_bits = 1;

    std::uint64_t total() const { return ends.back(); }

    /// The piece of a random word. The guide is Chen and Asau's (1974): few steps are left.
    std::size_t piece(std::uint64_t random) const;
};

/// The entries of the guide for so many pieces: a power of two.
std::size_t surface_guide_size(std::size_t pieces);

/// All triangles, whole.
std::vector<SurfacePiece> whole_pieces(const FixedSurface& surface);

/// The area of a piece, in squares of the mesh's units.
double area_of(const FixedSurface& surface, const SurfacePiece& piece);

/// The sum of their areas, added in an order that does not depend on the number of threads.
double area_of(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces);

bool is_last(const SurfacePiece& piece);

/// Pieces that are left of those with these states (PieceState): open ones are halved, or stay where they are last.
struct RefinedPieces
{
    std::vector<SurfacePiece> pieces;
    double small_area = 0; ///< of those that were dropped within the limit
    bool is_finer = false; ///< one was halved, or dropped
};

/// Refines pieces, and puts those that are left into `memory`, whose content is lost.
RefinedPieces refined(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                      const std::vector<std::uint32_t>& states, std::vector<SurfacePiece> memory = {});

/// There is one piece or more.
SurfacePieceChoice surface_piece_choice(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces);

/// One of pieces that have these weights in place of their areas.
SurfacePieceChoice surface_piece_choice(const std::vector<double>& weights);

}
