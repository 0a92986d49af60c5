#include "tiles/texture/texture_certificate.hpp"

#include "base/errors/errors.hpp"
#include "tiles/texture/marked_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

namespace poissonlab {
namespace {

/// The sides of a tile, and how far it is to go along and away from them.
enum Side : std::size_t
{
    north,
    east,
    south,
    west,
};
constexpr std::array side_names{"north", "east", "south", "west"};

/// The colours that tiles share at a side: of an edge, or of its western (southern) corner, then the other one.
using FacingColors = std::pair<Color, Color>;

FacingColors side_colors_at(const TextureSet& set, TileIndex index, Side side)
{
    if (!set.has_corners()) {
        const WangTile t = wang_tile(index, set.colors);
        const std::array colors{t.north, t.east, t.south, t.west};
        return {colors[side], 0};
    }
    const CornerTile t = corner_tile(index, set.colors.horizontal);
    const std::array<FacingColors, 4> colors{{{t.north_west, t.north_east},
                                              {t.south_east, t.north_east},
                                              {t.south_west, t.south_east},
                                              {t.south_west, t.north_west}}};
    return colors[side];
}

/// A pixel by its place along a side and its depth from it.
std::size_t pixel_at(const TextureSet& set, Side side, int along, int depth)
{
    const int last = set.size - 1;
    const std::array<std::pair<int, int>, 4> places{
        {{along, depth}, {last - depth, along}, {along, last - depth}, {depth, along}}};
    return static_cast<std::size_t>(places[side].second) * static_cast<std::size_t>(set.size) +
           static_cast<std::size_t>(places[side].first);
}

/// True if a pixel of the ring belongs to this side: with edges, pixels near corners belong to the nearest one, and to
/// north or south where two are as near.
bool belongs_to_side(const TextureSet& set, Side side, int along, int depth)
{
    if (set.has_corners()) return true;
    const int to_end = std::min(along, set.size - 1 - along);
    return side == north || side == south ? to_end >= depth : to_end > depth;
}

std::string tile_name(const TextureSet& set, std::size_t tile)
{
    return fmt::format("tile {}{}", set.tiles[tile].index,
                       set.tiles[tile].variant == 0 ? "" : fmt::format(" (variant {})", set.tiles[tile].variant));
}

class TextureProof
{
public:
    explicit TextureProof(const TextureSet& set) : set_(set) {}

    TextureCertificate run()
    {
        check_values();
        if (set_.marked_column > 0) check_marks();
        for (const Side side : {north, east, south, west}) check_rings(side);
        check_borders(east, west, {1, 0});
        check_borders(south, north, {0, 1});
        return certificate_;
    }

private:
    /// Tiles by the colours at a side.
    std::map<FacingColors, std::vector<std::size_t>> tiles_by_colors(Side side) const
    {
        std::map<FacingColors, std::vector<std::size_t>> tiles;
        for (std::size_t i = 0; i < set_.tiles.size(); ++i)
            tiles[side_colors_at(set_, set_.tiles[i].index, side)].push_back(i);
        return tiles;
    }

    std::span<const std::uint8_t> shown(std::size_t tile, std::size_t pixel) const
    {
        const auto channels = static_cast<std::size_t>(set_.exemplar.channels);
        return set_.values_of(tile).subspan(pixel * channels, channels);
    }

    bool is_in_ring(std::size_t pixel) const
    {
        const int x = static_cast<int>(pixel) % set_.size, y = static_cast<int>(pixel) / set_.size;
        return std::min({x, y, set_.size - 1 - x, set_.size - 1 - y}) < set_.ring;
    }

    /// Pixels are those of their sources, unless they were changed.
    void check_values() const
    {
        if (set_.is_changed()) return;
        const auto channels = static_cast<std::size_t>(set_.exemplar.channels);
        for (std::size_t tile = 0; tile < set_.tiles.size(); ++tile)
            for (std::size_t pixel = 0; pixel < set_.pixels_a_tile(); ++pixel) {
                if (set_.is_smoothed && !is_in_ring(pixel)) continue;
                const SourcePixel source = set_.sources_of(tile)[pixel];
                if (!std::ranges::equal(
                        shown(tile, pixel),
                        std::span(set_.exemplar.values).subspan(set_.exemplar.at(source.x, source.y, 0), channels)))
                    throw InputError(fmt::format("{}: the pixel in column {}, row {} is not its source's",
                                                 tile_name(set_, tile), pixel % static_cast<std::size_t>(set_.size),
                                                 pixel / static_cast<std::size_t>(set_.size)));
            }
    }

    /// Corners show the exemplar of their mark.
    void check_marks() const
    {
        const int last = set_.size - 1;
        for (std::size_t tile = 0; tile < set_.tiles.size(); ++tile) {
            const CornerTile marks = marks_of(set_, set_.tiles[tile].index);
            const auto check_corner = [&](Color mark, int x, int y, const char* name) {
                const SourcePixel source = set_.sources_of(tile)[static_cast<std::size_t>(y * set_.size + x)];
                if ((source.x >= set_.marked_column) != (mark == 1))
                    throw InputError(fmt::format("{}: its {} corner does not show the exemplar of {} corners",
                                                 tile_name(set_, tile), name, mark == 1 ? "marked" : "unmarked"));
            };
            check_corner(marks.north_east, last, 0, "north-eastern");
            check_corner(marks.south_east, last, last, "south-eastern");
            check_corner(marks.south_west, 0, last, "south-western");
            check_corner(marks.north_west, 0, 0, "north-western");
        }
    }

    void check_rings(Side side) const
    {
        for (const auto& [colors, tiles] : tiles_by_colors(side))
            for (const std::size_t tile : tiles)
                for (int depth = 0; depth < set_.ring; ++depth)
                    for (int along = 0; along < set_.size; ++along) {
                        if (!belongs_to_side(set_, side, along, depth)) continue;
                        const std::size_t pixel = pixel_at(set_, side, along, depth);
                        if (set_.sources_of(tile)[pixel] != set_.sources_of(tiles[0])[pixel] ||
                            !std::ranges::equal(shown(tile, pixel), shown(tiles[0], pixel)))
                            throw InputError(fmt::format("{}: its ring of {} pixels is not that of {} in the {}, with "
                                                         "the same colours there",
                                                         tile_name(set_, tile), set_.ring, tile_name(set_, tiles[0]),
                                                         side_names[side]));
                    }
    }

    /// Tiles whose `first` side lies at the `second` side of others.
    void check_borders(Side first, Side second, std::pair<int, int> step)
    {
        const auto others = tiles_by_colors(second);
        for (const auto& [colors, tiles] : tiles_by_colors(first)) {
            if (!others.contains(colors)) continue;
            const std::vector<std::size_t>& neighbours = others.at(colors);
            for (const std::size_t a : tiles)
                for (const std::size_t b : neighbours) {
                    ++certificate_.tile_pairs;
                    for (int along = 0; along < set_.size; ++along)
                        check_pair({tiles[0], neighbours[0]}, {a, b},
                                   {pixel_at(set_, first, along, 0), pixel_at(set_, second, along, 0)}, step,
                                   !belongs_to_side(set_, first, along, 0));
                }
        }
    }

    using Pair = std::pair<std::size_t, std::size_t>;

    /// `known` are the tiles that say what the colours predict.
    void check_pair(Pair known, Pair tiles, Pair pixels, std::pair<int, int> step, bool is_beside_corner)
    {
        ++certificate_.pixel_pairs;
        const SourcePixel a = set_.sources_of(tiles.first)[pixels.first];
        const SourcePixel b = set_.sources_of(tiles.second)[pixels.second];
        if (b.x - a.x == step.first && b.y - a.y == step.second) return;
        if (is_beside_corner) {
            ++certificate_.exceptions;
            return;
        }
        ++certificate_.joints;
        if (a != set_.sources_of(known.first)[pixels.first] || b != set_.sources_of(known.second)[pixels.second])
            throw InputError(
                fmt::format("{} and {}, side by side, have a joint that their shared colours do not predict",
                            tile_name(set_, tiles.first), tile_name(set_, tiles.second)));
    }

    const TextureSet& set_;
    TextureCertificate certificate_;
};

}

TextureCertificate certify_texture(const TextureSet& set) { return TextureProof(set).run(); }

}
