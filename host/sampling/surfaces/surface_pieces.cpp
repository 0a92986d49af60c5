#include "host/sampling/surfaces/surface_pieces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

using contract::surface::LIMIT;
using contract::surface::PIECE_OPEN;
using contract::surface::PIECE_SMALL;

constexpr std::uint32_t whole_share = 1u << contract::surface::BARYCENTRIC_BITS;

/// Guides have no more entries than that.
constexpr std::uint32_t most_guide_bits = 24;

MeshPlace corner_of(const FixedSurface& surface, const SurfacePiece& piece, std::size_t i)
{
    return place_on(surface.triangles[piece.triangle], piece.shares[2 * i], piece.shares[2 * i + 1]);
}

/// The longest edge of a piece, which begins at corner `from`, the first of equals.
struct LongestEdge
{
    std::size_t from = 0;
    std::uint64_t squared = 0;
};

LongestEdge longest_edge(const FixedSurface& surface, const SurfacePiece& piece)
{
    LongestEdge longest;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint64_t squared =
            squared_distance(corner_of(surface, piece, i), corner_of(surface, piece, (i + 1) % 3));
        if (squared > longest.squared) longest = {i, squared};
    }
    return longest;
}

/// Marks a piece that is divided no further.
void mark_if_last(const FixedSurface& surface, SurfacePiece& piece)
{
    const LongestEdge edge = longest_edge(surface, piece);
    const std::size_t a = 2 * edge.from, b = 2 * ((edge.from + 1) % 3);
    bool is_exact = true;
    for (std::size_t k = 0; k < 2; ++k)
        is_exact = is_exact && (piece.shares[a + k] + std::uint64_t{piece.shares[b + k]}) % 2 == 0;
    if (edge.squared <= std::uint64_t{LIMIT} * LIMIT || !is_exact) piece.halvings |= LAST_PIECE;
}

void add_halves(const FixedSurface& surface, const SurfacePiece& piece, std::vector<SurfacePiece>& to)
{
    const std::size_t from = longest_edge(surface, piece).from;
    const std::size_t ends[2] = {2 * from, 2 * ((from + 1) % 3)};
    for (const std::size_t replaced : ends) {
        SurfacePiece half = piece;
        for (std::size_t k = 0; k < 2; ++k)
            half.shares[replaced + k] =
                static_cast<std::uint32_t>((piece.shares[ends[0] + k] + std::uint64_t{piece.shares[ends[1] + k]}) / 2);
        ++half.halvings;
        mark_if_last(surface, half);
        to.push_back(half);
    }
}

}

std::size_t SurfacePieceChoice::piece(std::uint64_t random) const
{
    __extension__ using Wide = unsigned __int128;
    const auto target = static_cast<std::uint64_t>(Wide{random} * total() >> 64);
    std::size_t piece = guide[random >> (64 - guide_bits)];
    while (ends[piece] <= target) ++piece;
    return piece;
}

std::vector<SurfacePiece> whole_pieces(const FixedSurface& surface)
{
    std::vector<SurfacePiece> pieces(surface.triangles.size());
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
        pieces[i] = {.triangle = i, .halvings = 0, .shares = {0, 0, whole_share, 0, 0, whole_share}};
        mark_if_last(surface, pieces[i]);
    }
    return pieces;
}

double area_of(const FixedSurface& surface, const SurfacePiece& piece)
{
    return std::ldexp(surface.areas[piece.triangle], -static_cast<int>(piece.halvings & ~LAST_PIECE));
}

bool is_last(const SurfacePiece& piece) { return (piece.halvings & LAST_PIECE) != 0; }

RefinedPieces refined(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                      const std::vector<std::uint32_t>& states)
{
    RefinedPieces left;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (states[i] == PIECE_SMALL) left.small_area += area_of(surface, pieces[i]);
        if (states[i] != PIECE_OPEN) continue;
        if (is_last(pieces[i]))
            left.pieces.push_back(pieces[i]);
        else
            add_halves(surface, pieces[i], left.pieces);
    }
    return left;
}

SurfacePieceChoice surface_piece_choice(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces)
{
    double area = 0;
    for (const SurfacePiece& piece : pieces) area += area_of(surface, piece);
    SurfacePieceChoice choice;
    choice.ends.reserve(pieces.size());
    std::uint64_t end = 0;
    for (const SurfacePiece& piece : pieces) {
        end += std::max<std::uint64_t>(1, static_cast<std::uint64_t>(area_of(surface, piece) / area * 0x1p62));
        choice.ends.push_back(end);
    }
    choice.guide_bits = std::clamp(static_cast<std::uint32_t>(std::bit_width(pieces.size())), 1u, most_guide_bits);
    __extension__ using Wide = unsigned __int128;
    std::uint32_t piece = 0;
    for (std::uint64_t i = 0; i < std::uint64_t{1} << choice.guide_bits; ++i) {
        const auto target = static_cast<std::uint64_t>(Wide{i} * choice.total() >> choice.guide_bits);
        while (choice.ends[piece] <= target) ++piece;
        choice.guide.push_back(piece);
    }
    return choice;
}

}
