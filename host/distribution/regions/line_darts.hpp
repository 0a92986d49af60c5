// Pieces of lines, the positions on them that are free, and darts that fall onto these: what sets on lines are made of,
// of one kind (line_points.hpp) and of several classes (host/distribution/classes/class_lines.hpp).
#pragma once

#include "host/distribution/regions/region_darts.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace poissonlab {

using LinePlace = std::array<double, 2>;

/// Darts on lines have this attempt of random numbers, so that no other darts have the same ones.
inline constexpr std::uint32_t line_attempt = 0x6c696e65;

/// A piece of a line is straight.
struct LinePiece
{
    LinePlace from, to;
    std::uint32_t line = 0;
    std::uint64_t steps = 0; ///< positions are 0 to this one

    double length() const
    {
        const double x = to[0] - from[0], y = to[1] - from[1];
        return std::sqrt(x * x + y * y); // std::hypot differs between libraries
    }

    LinePlace at(std::uint64_t position) const
    {
        const double part = steps == 0 ? 0 : static_cast<double>(position) / static_cast<double>(steps);
        return {from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part};
    }
};

/// Computed distances are off by less than this, because places and ends of intervals are rounded.
double line_margin(double distance, const RegionBox& box);

/// Returns the edges of all lines; an edge that comes again, as where two parcels meet, counts once.
std::vector<LinePiece> edges_of(const std::vector<RegionRing>& lines);

double total_length(const std::vector<LinePiece>& edges);

/// Throws InputError where lines have so many of a distance that memory does not hold them.
void check_line_pieces(double length, double longest, double distance);

/// Divides edges into pieces that are no longer than a distance.
std::vector<LinePiece> pieces_of(const std::vector<LinePiece>& edges, double distance);

/// The parts of lines that are far enough from obstacles that are lines or polygons.
struct LinesLeft
{
    std::vector<RegionRing> lines;
    std::vector<std::size_t> numbers; ///< of the region's line that each part belongs to
};
LinesLeft lines_among(const RegionLand& land, double distance);

/// Counts the free positions of all pieces, and finds the one with a number, by a tree of sums (Fenwick 1994).
class FreePositions
{
    using Interval = std::pair<std::uint64_t, std::uint64_t>;

public:
    explicit FreePositions(const std::vector<LinePiece>& pieces);

    std::uint64_t count() const { return count_; }

    /// Returns the piece of the free position with a number, and the position on it.
    std::pair<std::size_t, std::uint64_t> free_one(std::uint64_t number) const;

    /// Takes the positions from `begin` to before `end`.
    void take(std::size_t piece, std::uint64_t begin, std::uint64_t end);

private:
    std::vector<std::vector<Interval>> free_;
    std::vector<std::uint64_t> sums_;
    std::uint64_t count_ = 0;
};

/// Throws darts onto pieces, which lie in cells of one and a half distances. Cells are found by bisection, so that
/// memory grows with the length of lines and not with the area around them.
class LineDarts
{
public:
    /// The pieces are no longer than the distance.
    LineDarts(std::vector<LinePiece> pieces, const RegionBox& box, double distance);

    bool is_full() const { return free_.count() == 0; }
    std::uint64_t free_count() const { return free_.count(); }

    /// Takes all positions nearer to a place than a distance, which must not be larger than that of the cells.
    void keep_away(const LinePlace& place, double distance);

    /// Throws one dart. Returns its place, and the line that it is on.
    std::pair<LinePlace, std::uint32_t> dart(std::uint64_t random);

private:
    std::int64_t cell(const LinePlace& place, std::size_t k) const;
    std::vector<LinePiece> in_cells(std::vector<LinePiece> pieces, const RegionBox& box, double distance);
    void keep_piece_away(std::size_t i, const LinePlace& place, double distance);

    RegionBox box_;
    double side_ = 0;
    std::vector<std::uint64_t> cells_; ///< of each piece, in order
    std::vector<LinePiece> pieces_;
    FreePositions free_;
};

}
