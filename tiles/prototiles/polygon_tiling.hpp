// Tilings by polygons as data: prototiles in an exact ring, and either a substitution, which says what tiles are
// divided into, or a period, which repeats some tiles.
//
// Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II), sections 3, 5, 6
// and 8.
#pragma once

#include "tiles/prototiles/root_ring.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// A circular arc around a corner, from one edge of the tile to the other: where two tiles meet, so do their arcs.
struct TileArc
{
    std::size_t corner = 0;
    double radius = 0;
    std::string color;
};

/// A point of an outline that two shifts p and q move: place + shifts[0] p + shifts[1] q.
struct ShiftedPlace
{
    RingPlace place;
    std::array<RingPlace, 2> shifts{};
};

struct Prototile
{
    std::string name;
    std::string color;              ///< "#rrggbb"
    std::vector<RingPlace> corners; ///< counterclockwise

    /// A letter for each edge, the first from corner 0 to corner 1; empty: edges have none. Two tiles may share an edge
    /// where one has a small letter and the other this letter as a capital one, or both have one digit.
    std::string edges;

    /// A more general outline with the same matching condition, which shifts change, and the letters of its edges;
    /// empty: there is none. Kaplan's quasivertices, section 8.3.
    std::vector<ShiftedPlace> outline;
    std::string outline_edges;

    std::vector<TileArc> arcs;
    bool is_regular = false; ///< a regular polygon
};

/// A point x of a prototile goes to at + turn x, or, in a mirror, to at + turn conj(x).
struct TileMotion
{
    RingPlace at;
    RingPlace turn{{1, 0, 0, 0}};
    bool is_mirrored = false;

    bool operator==(const TileMotion&) const = default;
};

struct PlacedTile
{
    std::size_t prototile = 0;
    TileMotion motion;

    bool operator==(const PlacedTile&) const = default;
};

/// Tiles with a name, from which a tiling may start.
struct StartPatch
{
    std::string name;
    std::vector<PlacedTile> tiles;
};

struct PolygonTiling
{
    std::string title;
    std::string source;
    RootRing ring;
    std::vector<Prototile> prototiles;

    /// The lengths of edges along even and along odd powers of z. Incidences and angles of tiles do not depend on these
    /// lengths, so that all places are stored as if edges had length 1.
    std::array<double, 2> lengths{1, 1};

    /// A substitution enlarges a tile by this map, and divides it into the parts of its prototile. Tiles without parts
    /// vanish when they are divided, because the place that they cover belongs to the parts of others.
    RingMap magnification;
    std::vector<std::vector<PlacedTile>> parts; ///< empty: the tiling is periodic
    std::vector<StartPatch> starts;             ///< the prototiles, and others

    std::array<RingPlace, 2> period{};
    std::vector<PlacedTile> unit; ///< what is repeated

    bool is_periodic() const { return parts.empty(); }
};

RingPlace moved(const RootRing& ring, const TileMotion& motion, const RingPlace& place);

/// The corners of a tile, counterclockwise.
std::vector<RingPlace> corners_of(const PolygonTiling& tiling, const PlacedTile& tile);

/// Returns x and y of a place, with the lengths of the tiling's edges.
std::array<double, 2> point_of(const PolygonTiling& tiling, const RingPlace& place);

/// Returns a place that is at most an edge away from a point.
RingPlace place_near(const PolygonTiling& tiling, const std::array<double, 2>& point);

/// The letter of the edge from corner `edge` of corners_of() to the next one; 0 where edges have no letters.
char edge_letter(const PolygonTiling& tiling, const PlacedTile& tile, std::size_t edge);

/// True if some tiles of one level are mirrored and others are not.
bool mixes_mirrored_tiles(const PolygonTiling& tiling);

/// True if tiles may share an edge that has these letters on its two sides.
bool letters_fit(char one, char other);

/// Four times the area, times i: an exact number of the ring, as areas themselves need not be.
RingPlace quadruple_area(const RootRing& ring, const std::vector<RingPlace>& corners);

/// Returns the area of a prototile, with the lengths of the tiling's edges.
double area_of(const PolygonTiling& tiling, std::size_t prototile);

/// The factor by which lengths of a tile are longer than those of its prototile: the absolute value of its turn.
double scale_of(const RootRing& ring, const TileMotion& motion);

}
