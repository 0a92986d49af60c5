// The pixels of a set of tiles, each once: tiles share what lies around their corners and along their edges.
//
// Pixels that are nearer than the ring to two sides of a tile belong to its corner, those near one side to the edge,
// all others to the tile alone. Corner tiles have a corner a colour and an edge for each pair of them; Wang tiles an
// edge a colour, and one corner that all of them have in common, so that they fit there as well.
#pragma once

#include "host/texture/texture_request.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The corners and edges that a tile is put together from, by their numbers.
struct TileParts
{
    std::array<std::uint32_t, 4> corners{};                 ///< north-west, north-east, south-west, south-east
    std::uint32_t west = 0, east = 0, north = 0, south = 0; ///< vertical edges, then horizontal ones
};

/// The corners at the ends of an edge: northern and southern, or western and eastern.
using EdgeEnds = std::array<std::uint32_t, 2>;

struct SetParts
{
    std::size_t corners = 0;
    std::vector<EdgeEnds> vertical, horizontal;
    std::vector<TileParts> tiles;
};

SetParts set_parts(const TextureRequest& request, const std::vector<TextureTile>& tiles);

/// Numbers the pixels of a set.
class SetCover
{
public:
    SetCover(SetParts parts, int size, int ring);

    const SetParts& parts() const { return parts_; }
    int size() const { return size_; }
    int ring() const { return ring_; }
    std::size_t pixels() const { return pixels_; }

    /// The pixel in column x and row y of a tile; at x or y = T that beyond its eastern or southern edge.
    std::size_t pixel(std::size_t tile, int x, int y) const;

    /// True for pixels that no other tile has.
    bool is_own(std::size_t pixel) const { return pixel >= first_own_; }
    /// True for pixels of corners.
    bool is_corner(std::size_t pixel) const { return pixel < first_vertical_; }

private:
    std::size_t corner_pixel(std::size_t corner, int x, int y) const;

    SetParts parts_;
    int size_, ring_;
    std::size_t first_vertical_ = 0, first_horizontal_ = 0, first_own_ = 0, pixels_ = 0;
};

/// The place of a tile: its north-western pixel, seen from the middle of a site.
struct PlacedTile
{
    std::size_t tile = 0;
    int x = 0;
    int y = 0;
};

/// A place of a set and all tiles that show it: a corner, the middle of an edge, or the middle of a tile. They lie over
/// each other, and what they share there is the same pixel.
struct Site
{
    enum class Kind
    {
        corner,
        vertical_edge,
        horizontal_edge,
        tile,
    };
    Kind kind = Kind::tile;
    std::uint32_t number = 0;
    std::vector<PlacedTile> tiles;
};

/// All sites: corners, vertical edges, horizontal edges, tiles.
std::vector<Site> sites_of(const SetCover& cover);

}
