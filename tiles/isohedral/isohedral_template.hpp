// The data that all tilings of an isohedral type have in common: the directions in which the corners of a tile can be
// moved, how it gets to its neighbours, and which of them make up a translational unit.
//
// Without printed tables: the Laves tile of the type has angles of 360 degrees over the degree of each vertex and a
// circle that touches all edges. A motion across an edge then has a known linear part, which it keeps however the tile
// is deformed. So the edges of a deformed tile obey linear equations: an edge is the image of the edge of the neighbour
// that lies on it, symmetries of the tile map edges to edges, and the edges close. What solves them, up to the tile's
// size and, where the tiling has no mirrors, its direction, are the parameters of the type. Kaplan, Introductory Tiling
// Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II, section 7), has the tables that this replaces.
#pragma once

#include "tiles/isohedral/tile_symbol.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace poissonlab {

// Motions of the plane: rotations, reflections, translations and what they make together.

using PlanePoint = std::array<double, 2>;

/// A point p goes to (xx p.x + xy p.y + x, yx p.x + yy p.y + y).
struct PlaneMotion
{
    double xx = 1, xy = 0, yx = 0, yy = 1;
    double x = 0, y = 0;

    PlanePoint linear(const PlanePoint& p) const { return {xx * p[0] + xy * p[1], yx * p[0] + yy * p[1]}; }
    PlanePoint operator()(const PlanePoint& p) const
    {
        const PlanePoint q = linear(p);
        return {q[0] + x, q[1] + y};
    }

    /// The product moves by `second` first, then by this motion.
    PlaneMotion operator*(const PlaneMotion& second) const
    {
        const PlanePoint moved = (*this)({second.x, second.y});
        return {xx * second.xx + xy * second.yx,
                xx * second.xy + xy * second.yy,
                yx * second.xx + yy * second.yx,
                yx * second.xy + yy * second.yy,
                moved[0],
                moved[1]};
    }

    bool is_mirror() const { return xx * yy - xy * yx < 0; }
};

/// The motion's inverse, as the linear part is orthogonal.
inline PlaneMotion inverse(const PlaneMotion& m)
{
    return {m.xx, m.yx, m.xy, m.yy, -(m.xx * m.x + m.yx * m.y), -(m.xy * m.x + m.yy * m.y)};
}

inline bool same_linear_part(const PlaneMotion& a, const PlaneMotion& b)
{
    constexpr double close = 1e-6; // linear parts of one tiling differ by far more, or by rounding
    return std::abs(a.xx - b.xx) + std::abs(a.xy - b.xy) + std::abs(a.yx - b.yx) + std::abs(a.yy - b.yy) < close;
}

/// Edges to hop across, one after the other.
using HopWord = std::vector<std::size_t>;

/// The way in which an edge has the curve that it shares with others: the curve goes from (0, 0) to (1, 0), with the
/// inside of the tile on its left for y > 0. `is_reversed`: x becomes 1 - x; `is_turned_over`: y becomes -y.
struct EdgeCurve
{
    std::size_t curve = 0;
    bool is_reversed = false;
    bool is_turned_over = false;
};

struct IsohedralTemplate
{
    TileSymbol symbol;
    std::vector<PlanePoint> base; ///< the corners of the Laves tile, counterclockwise around (0, 0)
    std::vector<std::vector<PlanePoint>> deformations; ///< of each parameter: where it moves the corners, of length 1
    std::vector<PlaneMotion> hops;                     ///< linear parts of the motions across edges
    std::vector<PlaneMotion> symmetries;               ///< of the tile; without translations
    std::vector<HopWord> aspects; ///< the tiles of a translational unit; the first is the tile itself
    std::array<std::array<HopWord, 2>, 2>
        translations; ///< T1, T2: from the tile of the first word to that of the second
    std::vector<EdgeCurve> edge_curves;
    std::vector<EdgeShape> curve_shapes; ///< what each curve may be

    std::size_t parameters() const { return deformations.size(); }
};

IsohedralTemplate isohedral_template(const TileSymbol& symbol);

/// True where shapes cannot tell the type: some more symmetric type has as many parameters and the same curves, so that
/// every tile has these symmetries as well. Its tiles need markings.
bool needs_markings(const IsohedralTemplate& type);

/// The motions across the edges of a tile with these corners.
std::vector<PlaneMotion> hops_of(const IsohedralTemplate& type, const std::vector<PlanePoint>& corners);

/// The motion that a word of hops leads to.
PlaneMotion motion_of(const HopWord& word, const std::vector<PlaneMotion>& hops);

/// The area inside of a polygon, counterclockwise.
double area_of(const std::vector<PlanePoint>& polygon);

}
