#include "host/distribution/textures/mark_pictures.hpp"

#include "host/distribution/textures/painting.hpp"
#include "tiles/texture/marked_tiles.hpp"

#include <algorithm>
#include <vector>

namespace poissonlab {
namespace {

using namespace painting;

constexpr int mark_columns = 4;

/// A red dot with a white rim.
void put_dot(PngPixels& picture, int x, int y, int radius)
{
    for (int dy = -radius; dy < radius; ++dy)
        for (int dx = -radius; dx < radius; ++dx) {
            const int square = (2 * dx + 1) * (2 * dx + 1) + (2 * dy + 1) * (2 * dy + 1);
            if (square > 4 * radius * radius) continue;
            put(picture, x + dx, y + dy, square > 4 * (radius - 1) * (radius - 1) ? Rgb{255, 255, 255} : tints[0]);
        }
}

/// Dots at the marked corners of a tile whose north-western pixel is at (left, top).
void put_mark_dots(PngPixels& picture, const TextureSet& set, std::size_t tile, int left, int top)
{
    const CornerTile marks = marks_of(set, set.tiles[tile].index);
    const int size = set.size, radius = std::max(2, size / 10);
    if (marks.north_west == 1) put_dot(picture, left, top, radius);
    if (marks.north_east == 1) put_dot(picture, left + size, top, radius);
    if (marks.south_west == 1) put_dot(picture, left, top + size, radius);
    if (marks.south_east == 1) put_dot(picture, left + size, top + size, radius);
}

}

PngPixels marks_picture(const TextureSet& set)
{
    std::vector<std::size_t> tiles;
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile)
        if (differ_in_marks_alone(set, set.tiles[tile].index, set.tiles[0].index)) tiles.push_back(tile);
    const int count = static_cast<int>(tiles.size()), step = set.size + shown_gap;
    PngPixels picture =
        blank(mark_columns * step + shown_gap, (count + mark_columns - 1) / mark_columns * step + shown_gap);
    for (int i = 0; i < count; ++i) {
        const std::size_t tile = tiles[static_cast<std::size_t>(i)];
        const int left = i % mark_columns * step + shown_gap, top = i / mark_columns * step + shown_gap;
        put_picture(picture, tile_picture(set, tile), left, top);
        put_mark_dots(picture, set, tile, left, top);
    }
    return enlarged(picture, shown_zoom);
}

PngPixels marked_window_picture(const TextureSet& set, const TextureWindow& window)
{
    PngPixels picture = colored(texture_window_pixels(set, window, set.values, set.exemplar.channels));
    for (std::size_t i = 0; i < window.tiles.size(); ++i)
        put_mark_dots(picture, set, window.tiles[i], static_cast<int>(i % window.columns) * set.size,
                      static_cast<int>(i / window.columns) * set.size);
    return picture;
}

}
