#include "host/distribution/regions/line_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/polygon_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace poissonlab {
namespace {

constexpr double line_positions = 0x1p52; ///< on all lines together
constexpr double most_pieces_of_lines = 0x1p25;
constexpr double most_line_cells = 0x1p31; ///< along a side of the box

/// Arcs of polygons around obstacles lie inside their circles by less than this part of the distance: see grown().
constexpr double arc_loss = 4e-5;

__extension__ using WideWord = unsigned __int128;

std::uint64_t key_of_cell(std::int64_t column, std::int64_t row)
{
    return (static_cast<std::uint64_t>(row) << 32) | static_cast<std::uint64_t>(column);
}

}

double line_margin(double distance, const RegionBox& box) { return 4 * distance_rounding(distance, box); }

std::vector<LinePiece> edges_of(const std::vector<RegionRing>& lines)
{
    std::vector<LinePiece> edges;
    for (std::size_t line = 0; line < lines.size(); ++line)
        for (std::size_t i = 1; i < lines[line].size(); ++i)
            if (lines[line][i - 1] != lines[line][i])
                edges.push_back({lines[line][i - 1], lines[line][i], static_cast<std::uint32_t>(line)});
    const auto ends = [&](std::size_t i) -> std::pair<LinePlace, LinePlace> {
        return std::minmax(edges[i].from, edges[i].to);
    };
    std::vector<std::size_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(ends(i), i); });
    std::vector<bool> comes_again(edges.size());
    for (std::size_t k = 1; k < order.size(); ++k) comes_again[order[k]] = ends(order[k]) == ends(order[k - 1]);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!comes_again[i]) edges[kept++] = edges[i];
    edges.resize(kept);
    return edges;
}

double total_length(const std::vector<LinePiece>& edges)
{
    double length = 0;
    for (const LinePiece& edge : edges) length += edge.length();
    return length;
}

void check_line_pieces(double length, double longest, double distance)
{
    if (length / distance > most_pieces_of_lines || longest / distance > most_line_cells)
        throw InputError(
            fmt::format("lines of {:.6g} have more than {:.0f} distances of {:.3g}, or are more than {:.0f} "
                        "distances across: more than memory holds",
                        length, most_pieces_of_lines, distance, most_line_cells));
}

std::vector<LinePiece> pieces_of(const std::vector<LinePiece>& edges, double distance)
{
    const double length = total_length(edges);
    std::vector<LinePiece> pieces;
    for (const LinePiece& edge : edges) {
        const double count = std::max(1.0, std::ceil(edge.length() / distance));
        LinePiece piece{edge.from, edge.from, edge.line};
        for (double i = 1; i <= count; ++i) {
            piece.from = piece.to;
            for (std::size_t k = 0; k < 2; ++k)
                piece.to[k] = i == count ? edge.to[k] : edge.from[k] + (edge.to[k] - edge.from[k]) * (i / count);
            piece.steps = static_cast<std::uint64_t>(piece.length() / length * line_positions);
            pieces.push_back(piece);
        }
    }
    return pieces;
}

LinesLeft lines_among(const RegionLand& land, double distance)
{
    LinesLeft left{lines_of(land.whole), {}};
    const Obstacles walls{{}, land.obstacles.lines, land.obstacles.polygons};
    if (walls.count() > 0) {
        left.lines = lines_without(left.lines, grown(walls, distance * (1 + arc_loss)), left.numbers);
        return left;
    }
    left.numbers.resize(left.lines.size());
    std::iota(left.numbers.begin(), left.numbers.end(), 0);
    return left;
}

FreePositions::FreePositions(const std::vector<LinePiece>& pieces) : sums_(pieces.size() + 1)
{
    for (const LinePiece& piece : pieces) free_.push_back({Interval{0, piece.steps + 1}});
    for (std::size_t i = 1; i < sums_.size(); ++i) sums_[i] += pieces[i - 1].steps + 1;
    for (std::size_t i = 1; i < sums_.size(); ++i)
        if (const std::size_t next = i + (i & (~i + 1)); next < sums_.size()) sums_[next] += sums_[i];
    for (const LinePiece& piece : pieces) count_ += piece.steps + 1;
}

std::pair<std::size_t, std::uint64_t> FreePositions::free_one(std::uint64_t number) const
{
    std::size_t piece = 0;
    for (std::size_t step = std::bit_floor(sums_.size() - 1); step > 0; step /= 2)
        if (piece + step < sums_.size() && sums_[piece + step] <= number) {
            piece += step;
            number -= sums_[piece];
        }
    for (const auto& [begin, end] : free_[piece]) {
        if (number < end - begin) return {piece, begin + number};
        number -= end - begin;
    }
    throw std::logic_error("a free position has no place"); // the sums are those of the intervals
}

void FreePositions::take(std::size_t piece, std::uint64_t begin, std::uint64_t end)
{
    std::vector<Interval> left;
    std::uint64_t taken = 0;
    for (const auto& [from, to] : free_[piece]) {
        const std::uint64_t low = std::clamp(begin, from, to), high = std::clamp(end, low, to);
        taken += high - low;
        if (from < low) left.emplace_back(from, low);
        if (high < to) left.emplace_back(high, to);
    }
    if (taken == 0) return;
    free_[piece] = std::move(left);
    count_ -= taken;
    for (std::size_t i = piece + 1; i < sums_.size(); i += i & (~i + 1)) sums_[i] -= taken;
}

LineDarts::LineDarts(std::vector<LinePiece> pieces, const RegionBox& box, double distance)
    : pieces_(in_cells(std::move(pieces), box, distance)), free_(pieces_)
{}

void LineDarts::keep_away(const LinePlace& place, double distance)
{
    for (std::size_t k = 0; k < 2; ++k)
        if (place[k] < box_.low[k] - 2 * side_ || place[k] > box_.high[k] + 2 * side_) return;
    const std::int64_t column = cell(place, 0), row = cell(place, 1);
    for (std::int64_t r = row - 1; r <= row + 1; ++r) {
        auto at = std::ranges::lower_bound(cells_, key_of_cell(column - 1, r));
        for (; at != cells_.end() && *at <= key_of_cell(column + 1, r); ++at)
            keep_piece_away(static_cast<std::size_t>(at - cells_.begin()), place, distance);
    }
}

std::pair<LinePlace, std::uint32_t> LineDarts::dart(std::uint64_t random)
{
    const auto number = static_cast<std::uint64_t>((static_cast<WideWord>(random) * free_.count()) >> 64);
    const auto [piece, position] = free_.free_one(number);
    free_.take(piece, position, position + 1);
    return {pieces_[piece].at(position), pieces_[piece].line};
}

std::int64_t LineDarts::cell(const LinePlace& place, std::size_t k) const
{
    return static_cast<std::int64_t>(std::floor((place[k] - box_.low[k]) / side_)) + 2;
}

std::vector<LinePiece> LineDarts::in_cells(std::vector<LinePiece> pieces, const RegionBox& box, double distance)
{
    box_ = box;
    side_ = 1.5 * distance * (1 + 0x1p-20);
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const LinePlace middle{(pieces[i].from[0] + pieces[i].to[0]) / 2, (pieces[i].from[1] + pieces[i].to[1]) / 2};
        order.emplace_back(key_of_cell(cell(middle, 0), cell(middle, 1)), i);
    }
    std::ranges::sort(order);
    std::vector<LinePiece> sorted;
    for (const auto& [cell, piece] : order) {
        cells_.push_back(cell);
        sorted.push_back(pieces[piece]);
    }
    return sorted;
}

void LineDarts::keep_piece_away(std::size_t i, const LinePlace& place, double distance)
{
    const LinePiece& piece = pieces_[i];
    const LinePlace along{piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]};
    const LinePlace there{place[0] - piece.from[0], place[1] - piece.from[1]};
    const double length = piece.length(), steps = static_cast<double>(piece.steps);
    const double beside = std::abs(along[0] * there[1] - along[1] * there[0]) / length;
    if (!(beside < distance)) return;
    const double foot = (along[0] * there[0] + along[1] * there[1]) / length;
    const double half = std::sqrt((distance - beside) * (distance + beside));
    // A piece that is shorter than a step has the position 0 alone.
    const double unit = piece.steps == 0 ? 1 : steps / length;
    const double first = std::floor((foot - half) * unit) + 1, last = std::ceil((foot + half) * unit) - 1;
    if (last < 0 || first > steps || last < first) return;
    free_.take(i, static_cast<std::uint64_t>(std::max(first, 0.0)),
               static_cast<std::uint64_t>(std::min(last, steps)) + 1);
}

}
