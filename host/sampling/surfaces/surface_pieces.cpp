#include "host/sampling/surfaces/surface_pieces.hpp"

#include "base/programs/large_pages.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

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

/// Puts the halves of a piece into two places. Returns the next one.
SurfacePiece* put_halves(const FixedSurface& surface, const SurfacePiece& piece, SurfacePiece* to)
{
    const std::size_t from = longest_edge(surface, piece).from;
    const std::size_t ends[2] = {2 * from, 2 * ((from + 1) % 3)};
    for (const std::size_t replaced : ends) {
        SurfacePiece& half = *to++;
        half = piece;
        for (std::size_t k = 0; k < 2; ++k)
            half.shares[replaced + k] =
                static_cast<std::uint32_t>((piece.shares[ends[0] + k] + std::uint64_t{piece.shares[ends[1] + k]}) / 2);
        ++half.halvings;
        mark_if_last(surface, half);
    }
    return to;
}

/// Pieces on which threads work together.
constexpr std::size_t pieces_a_part = 1 << 14;

/// Calls work(part, begin, end) for each part of so many pieces, by all threads.
template <class Work>
void by_parts(std::size_t count, Work work)
{
    tbb::parallel_for(std::size_t{0}, (count + pieces_a_part - 1) / pieces_a_part, [&](std::size_t part) {
        work(part, part * pieces_a_part, std::min((part + 1) * pieces_a_part, count));
    });
}

/// The sum of numbers, added in an order that does not depend on the threads.
template <class Number>
double sum_of(std::size_t count, Number number)
{
    std::vector<double> sums(count / pieces_a_part + 1);
    by_parts(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) sums[part] += number(i);
    });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
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
    constexpr std::uint64_t exponent_of_one = 1023, exponent_place = 52; // of doubles; ldexp() takes ten times as long
    const std::uint64_t exponent = exponent_of_one - (piece.halvings & ~LAST_PIECE);
    return surface.areas[piece.triangle] * std::bit_cast<double>(exponent << exponent_place);
}

double area_of(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces)
{
    return sum_of(pieces.size(), [&](std::size_t i) { return area_of(surface, pieces[i]); });
}

bool is_last(const SurfacePiece& piece) { return (piece.halvings & LAST_PIECE) != 0; }

namespace {

/// Refines pieces `begin` to `end`, and puts what is left of them into places from `to` on.
RefinedPieces refined_from(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                           const std::vector<std::uint32_t>& states, std::size_t begin, std::size_t end,
                           SurfacePiece* to)
{
    RefinedPieces seen;
    for (std::size_t i = begin; i < end; ++i) {
        if (states[i] == PIECE_SMALL) seen.small_area += area_of(surface, pieces[i]);
        seen.is_finer = seen.is_finer || states[i] != PIECE_OPEN || !is_last(pieces[i]);
        if (states[i] != PIECE_OPEN) continue;
        if (is_last(pieces[i]))
            *to++ = pieces[i];
        else
            to = put_halves(surface, pieces[i], to);
    }
    return seen;
}

}

RefinedPieces refined(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                      const std::vector<std::uint32_t>& states, std::vector<SurfacePiece> memory)
{
    const std::size_t count = (pieces.size() + pieces_a_part - 1) / pieces_a_part;
    std::vector<std::size_t> starts(count + 1); // of what is left of each part
    by_parts(pieces.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (states[i] == PIECE_OPEN) starts[part + 1] += is_last(pieces[i]) ? 1 : 2;
    });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    RefinedPieces left;
    left.pieces = std::move(memory);
    if (left.pieces.capacity() < starts.back()) {
        left.pieces = {};
        left.pieces.reserve(starts.back());
        ask_for_large_pages(left.pieces.data(), starts.back() * sizeof(SurfacePiece));
    }
    left.pieces.resize(starts.back());
    std::vector<RefinedPieces> parts(count);
    by_parts(pieces.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
        parts[part] = refined_from(surface, pieces, states, begin, end, left.pieces.data() + starts[part]);
    });
    for (const RefinedPieces& part : parts) {
        left.small_area += part.small_area;
        left.is_finer = left.is_finer || part.is_finer;
    }
    return left;
}

std::size_t surface_guide_size(std::size_t pieces)
{
    return std::size_t{1} << std::clamp(static_cast<std::uint32_t>(std::bit_width(pieces)), 1u, most_guide_bits);
}

namespace {

/// The first piece that each entry of a guide leads to.
void fill_guide(SurfacePieceChoice& choice)
{
    __extension__ using Wide = unsigned __int128;
    choice.guide.resize(std::size_t{1} << choice.guide_bits);
    const auto target_of = [&](std::size_t entry) {
        return static_cast<std::uint64_t>(Wide{entry} * choice.total() >> choice.guide_bits);
    };
    by_parts(choice.guide.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        const auto first = std::ranges::upper_bound(choice.ends, target_of(begin));
        auto piece = static_cast<std::uint32_t>(first - choice.ends.begin());
        for (std::size_t i = begin; i < end; ++i) {
            while (choice.ends[piece] <= target_of(i)) ++piece;
            choice.guide[i] = piece;
        }
    });
}

/// The table of so many pieces that have these weights.
template <class Weight>
SurfacePieceChoice choice_of(std::size_t count, Weight weight)
{
    const double sum = sum_of(count, weight);
    SurfacePieceChoice choice;
    choice.ends.resize(count);
    std::vector<std::uint64_t> starts(count / pieces_a_part + 2); // of each part
    by_parts(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
        std::uint64_t own = 0;
        for (std::size_t i = begin; i < end; ++i) {
            own += std::max<std::uint64_t>(1, static_cast<std::uint64_t>(weight(i) / sum * 0x1p62));
            choice.ends[i] = own;
        }
        starts[part + 1] = own;
    });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    by_parts(count, [&](std::size_t part, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) choice.ends[i] += starts[part];
    });
    choice.guide_bits = static_cast<std::uint32_t>(std::bit_width(surface_guide_size(count))) - 1;
    fill_guide(choice);
    return choice;
}

}

SurfacePieceChoice surface_piece_choice(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces)
{
    return choice_of(pieces.size(), [&](std::size_t i) { return area_of(surface, pieces[i]); });
}

SurfacePieceChoice surface_piece_choice(const std::vector<double>& weights)
{
    return choice_of(weights.size(), [&](std::size_t i) { return weights[i]; });
}

}
