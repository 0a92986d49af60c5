#include "host/distribution/textures/step_picture.hpp"

#include "host/distribution/textures/painting.hpp"

#include <algorithm>
#include <array>

namespace poissonlab {
namespace {

using namespace painting;

/// The patches of a tile's corners as they lie around its middle: north-west, north-east, south-west, south-east.
std::array<Color, 4> patches_of(const CornerTile& t)
{
    return {t.north_west, t.north_east, t.south_west, t.south_east};
}

/// Four whole patches, each tinted: what the tile is cut out of.
PngPixels assembled(const BuiltTexture& built, const std::array<Color, 4>& corners)
{
    const int size = built.set.size;
    PngPixels picture = blank(2 * size, 2 * size);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        PngPixels patch = colored(window_pixels(built.set.exemplar, built.windows[corners[i]]));
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                put(patch, x, y, tinted(color_at(patch, x, y), tints[corners[i] % tints.size()]));
        put_picture(picture, patch, static_cast<int>(i % 2) * size, static_cast<int>(i / 2) * size);
    }
    return picture;
}

/// The middle of a picture, half of each side.
PngPixels middle_of(const PngPixels& picture)
{
    const int size = picture.width / 2;
    PngPixels middle = blank(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) put(middle, x, y, color_at(picture, x + size / 2, y + size / 2));
    return middle;
}

/// The tile with what is left of its patches in their tints, and new pieces in grey.
PngPixels patch_picture(const BuiltTexture& built, std::size_t tile, const std::array<Color, 4>& corners)
{
    constexpr Rgb grey{128, 128, 128};
    const int size = built.set.size, half = size / 2;
    PngPixels picture = colored(tile_picture(built.set, tile));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const Color color = corners[(y < half ? 0u : 2u) + (x < half ? 0u : 1u)];
            const ExemplarWindow& patch = built.windows[color];
            const SourcePixel source = built.set.sources_of(tile)[static_cast<std::size_t>(y * size + x)];
            const bool is_patch = source.x == patch.x + patch.size / 2 + (x < half ? x : x - size) &&
                                  source.y == patch.y + patch.size / 2 + (y < half ? y : y - size);
            put(picture, x, y, tinted(color_at(picture, x, y), is_patch ? tints[color % tints.size()] : grey));
        }
    return picture;
}

}

PngPixels step_picture(const BuiltTexture& built)
{
    const TextureSet& set = built.set;
    const Color colors = set.colors.horizontal;
    const TileIndex wanted = corner_index({1 % colors, 3 % colors, 2 % colors, 0}, colors);
    const auto found = std::ranges::find(set.tiles, wanted, &TextureTile::index);
    const auto tile = found == set.tiles.end() ? std::size_t{0} : static_cast<std::size_t>(found - set.tiles.begin());
    const std::array<Color, 4> corners = patches_of(corner_tile(set.tiles[tile].index, colors));
    const PngPixels patches = assembled(built, corners);
    const std::array<PngPixels, 4> steps{patches, middle_of(patches), tile_picture(set, tile),
                                         patch_picture(built, tile, corners)};
    const int large = 2 * set.size * shown_zoom;
    PngPixels picture = blank(4 * large / 2 + large / 2 + 3 * shown_gap, large);
    int left = 0;
    for (const PngPixels& step : steps) {
        const PngPixels shown = enlarged(step, shown_zoom);
        put_picture(picture, shown, left, (large - shown.height) / 2);
        left += shown.width + shown_gap;
    }
    return picture;
}

}
