// Jigsaw pieces: tiles whose sides have profiles that fit where their colours are the same, and nowhere else.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5.4 and figure 5.13, after MacMahon, New Mathematical
// Pastimes, 1921. The profiles are ours: a knob on one side of the line or the other, at a place that tells the colour.
// Wang tiles have one a side. Around a corner, a knob on each of its four lines, turned from one to the next by 90
// degrees, so that the colour of a corner is seen in each of the four pieces that meet there.
#pragma once

#include "tiles/tilings/tile_set.hpp"

#include <array>
#include <vector>

namespace poissonlab {

using PiecePoint =
    std::array<double, 2>; ///< x eastwards, y northwards, in tiles from the lower left corner of the tile

/// The line between two pieces from (0, 0) to (1, 0): `start` and `end` are the colours of its corners, of Wang tiles
/// `start` is that of the edge. Lines from south to north are the same turned by 90 degrees.
std::vector<PiecePoint> side_profile(TileKind kind, Color start, Color end, Color colors);

/// The sides of a tile as pieces of the outline, counterclockwise: south, east, north, west; each ends where the next
/// begins. Wang or corner tiles.
std::array<std::vector<PiecePoint>, 4> piece_sides(TileKind kind, TileIndex tile, Color colors);

/// The sides together, without the first point again at the end.
std::vector<PiecePoint> piece_outline(TileKind kind, TileIndex tile, Color colors);

/// The outline of all points within a distance of a piece: what a cut of twice that width leaves of it is the piece.
/// Counterclockwise.
std::vector<PiecePoint> grown_outline(const std::vector<PiecePoint>& outline, double distance);

}
