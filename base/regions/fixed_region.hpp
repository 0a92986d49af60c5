// A region in whole numbers: exact and fast answers to what lies inside.
//
// Its corners are rounded to a grid of 2^31 positions along its longest side, a corner of the unit torus' fixed-point
// coordinates: nothing in it is nearer to anything around the torus than within it, differences have 31 bits, and the
// cross product of two of them fits into 64. What lies on an edge is inside.
//
// A grid of 2^bits cells along each axis covers these positions. A cell has the edges that touch it, and says whether
// its lowest corner is inside. Cells with many edges, as regions have that fill little of their square, are divided by
// another 2^fine_bits along each axis. From there to a position one goes along y, then along x, and counts the edges
// that are crossed. Corner and position are moved by (e^2, e) for that, with an e smaller than any number, so that no
// edge is touched. kernels/common/regions/inside_region.clh does the same.
//
// With a margin positions that are nearer than it to an edge are outside as well, and cells have all edges that are so
// near to them. Lines and points to keep away from are edges with margins of their own, which nothing is inside of.
#pragma once

#include "base/geometry/torus.hpp"
#include "base/regions/plane_region.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

/// An edge from its lower end to its upper one: x, y, x, y. The highest bit of the first x is that of lines to keep
/// away from, the highest bit of the second x that of points.
using FixedEdge = std::array<std::uint32_t, 4>;

/// The kinds of edges; margins are listed in this order.
enum class FixedEdgeKind : std::uint32_t
{
    boundary,
    line,
    point
};

/// Edges and points that positions keep away from besides the boundary.
struct KeptAway
{
    std::vector<std::array<double, 4>> lines;  ///< from x, y to x, y in units of the region
    std::vector<std::array<double, 2>> points; ///< in these units
    double from_lines = 0;                     ///< the margin of lines, in unit lengths of the torus
    double from_points = 0;                    ///< that of points
    RegionBox box; ///< which all of this lies in, and the region: the grid is that of this box
};

/// Positions low, low + 1, ..., high along each axis.
struct FixedBox
{
    TorusPoint<2> low{};
    TorusPoint<2> high{};
};

/// The side of the boundary on which the positions of a box are. Boxes whose sides are much larger than cells are
/// looked at roughly: they may be said to be crossed although they are not.
enum class RegionSide
{
    outside, ///< all of them
    crossed,
    inside ///< all of them
};

class FixedRegion
{
public:
    static constexpr int coordinate_bits = 31;

    /// The side of the torus in units of a region in this box.
    static double torus_side(const RegionBox& box) { return box.longest() / ((1u << coordinate_bits) - 1) * 0x1p32; }

    /// Takes a region that check_region() accepts. `margin` is in unit lengths of the torus, from 0 to 1/2.
    explicit FixedRegion(const PlaneRegion& region, double margin = 0);

    FixedRegion(const PlaneRegion& region, double margin, const KeptAway& kept_away);

    bool contains(const TorusPoint<2>& position) const { return contains(position, true); }

    /// Is the position inside that is nearest to a place in the region's own units?
    bool contains_place(const std::array<double, 2>& place) const;

    /// Is a position inside? Looks at all edges instead of the grid: to test it.
    bool contains_plainly(const TorusPoint<2>& position) const;

    /// Is the position inside when it is moved by (e^2, e), margins aside? It is on no edge, then.
    bool contains_moved(const TorusPoint<2>& position) const;

    RegionSide side_of(const FixedBox& box) const;

    /// Finds the edges of the boundary that cross a box. Returns false if there are too many of them, if one ends in
    /// the box, or if the region has margins there. If true, two positions in the box that lie on no edge are both
    /// inside or both outside exactly when an even number of the edges' lines separate them.
    bool find_crossing(const FixedBox& box, std::vector<FixedEdge>& edges) const;
    static constexpr std::size_t most_crossing = 4;

    /// The least box that has the region inside, in the grid.
    const FixedBox& extent() const { return extent_; }

    /// A position in the region's own units: its lowest corner and `unit` times the position, rounded once each.
    std::array<double, 2> own(const TorusPoint<2>& position) const;

    double unit() const { return unit_; }
    double area() const { return area_; }         ///< in squares of its own units
    const RegionBox& box() const { return box_; } ///< in its own units

    // These functions return the parts of the grid.
    int bits() const { return bits_; }
    int fine_bits() const { return fine_bits_; }                             ///< 0: no cell is divided
    const std::array<std::uint32_t, 3>& margins() const { return margins_; } ///< in positions, rounded up
    /// The squares of the margins, in units of 2^-64, rounded up.
    const std::array<std::uint64_t, 3>& squared_margins() const { return squared_margins_; }

    /// For each cell, x fastest, twice the number of its first edge in edges(), plus 1 where its lowest corner is
    /// inside; then the end of the last.
    std::span<const std::uint32_t> cells() const { return std::span(cells_).first(cell_count() + 1); }

    /// The cells and, where some are divided, a value for each cell: where in this list its parts begin, or 0. Parts
    /// are as cells are, x fastest, with the end of the last.
    std::span<const std::uint32_t> all_cells() const { return cells_; }
    std::span<const FixedEdge> edges() const { return listed_; }

    /// Each edge of the boundary once, from x, y to x, y, with the region on its left.
    std::vector<FixedEdge> directed_boundary() const;

    /// The number of cells below and left of each corner of the grid that are not outside altogether.
    std::span<const std::uint32_t> filled() const { return filled_; }

private:
    TorusPoint<2> rounded(const std::array<double, 2>& corner) const;
    void add_edge(const std::array<double, 2>& from, const std::array<double, 2>& to, FixedEdgeKind kind,
                  bool lies_right = false);
    void add_ring(const RegionRing& ring, bool is_hole);

    /// The facts about a position, with margins or without.
    struct Inside
    {
        bool moved = false; ///< as contains_moved()
        bool is_on_edge = false;
        bool is_too_near = false; ///< the rest is not known, then
    };
    Inside look_at(const TorusPoint<2>& position, bool has_margins) const;

    /// Is the position inside? With margins: and no nearer to an edge than its margin?
    bool contains(const TorusPoint<2>& position, bool has_margins) const;
    bool is_too_near(const FixedEdge& edge, const TorusPoint<2>& position) const;
    std::uint32_t margin_of(const FixedEdge& edge) const;
    std::uint64_t squared_margin_of(const FixedEdge& edge) const;

    /// Calls found(column, row) for the cells 2^shift positions wide in a block that an edge is near.
    void find_cells(std::size_t edge, const FixedBox& block, int shift,
                    const std::function<void(std::uint32_t, std::uint32_t)>& found) const;

    void list_edges();
    void find_corners();
    void count_filled();
    void divide_cells();
    void divide(std::size_t cell, int bits);
    std::vector<bool> corners_inside(std::span<const FixedEdge> of_cell, const TorusPoint<2>& first, int part_shift,
                                     int bits) const;

    template <typename What>
    void for_each_edge_of_cells(const FixedBox& box, const What& what) const;

    std::uint32_t size() const { return 1u << bits_; }
    int shift() const { return coordinate_bits - bits_; }
    std::size_t cell_count() const { return std::size_t{1} << 2 * bits_; }
    std::size_t cell_at(std::uint32_t column, std::uint32_t row) const { return std::size_t{row} << bits_ | column; }

    /// A cell of the list, or a part of one, and its width.
    struct FoundCell
    {
        std::size_t number;
        int shift;
    };
    FoundCell cell_with(const TorusPoint<2>& position) const;
    std::span<const FixedEdge> edges_of(std::size_t cell) const
    {
        return std::span(listed_).subspan(cells_[cell] / 2, cells_[cell + 1] / 2 - cells_[cell] / 2);
    }

    RegionBox box_;
    double unit_ = 1, area_ = 0;
    int bits_ = 0, fine_bits_ = 0;
    std::array<std::uint32_t, 3> margins_{};         ///< rounded up
    std::array<std::uint64_t, 3> squared_margins_{}; ///< of margins that are not rounded
    FixedBox extent_{};
    std::vector<FixedEdge> edges_;      ///< each once
    bool has_coinciding_edges_ = false; ///< as rounding makes of a gap between polygons
    std::vector<bool> lies_right_;      ///< for each of them, of the region, on the way up
    std::vector<FixedEdge> listed_;
    std::vector<std::uint32_t> listed_numbers_; ///< in `edges_`, of those of whole cells
    std::vector<std::uint32_t> cells_, filled_;
};

}
