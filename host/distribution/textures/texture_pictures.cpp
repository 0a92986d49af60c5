#include "host/distribution/textures/texture_pictures.hpp"

#include "host/distribution/textures/painting.hpp"
#include "tiles/texture/marked_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

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

using namespace painting;

void put_frame(PngPixels& picture, const ExemplarWindow& window, Rgb color, int thickness)
{
    for (int inset = 0; inset < thickness; ++inset)
        for (int i = inset; i < window.size - inset; ++i) {
            const int far = window.size - 1 - inset;
            put(picture, window.x + i, window.y + inset, color);
            put(picture, window.x + i, window.y + far, color);
            put(picture, window.x + inset, window.y + i, color);
            put(picture, window.x + far, window.y + i, color);
        }
}

/// Tints of windows in the order in which they are met. A window's offset from a tile is the same in all of its pixels
/// there, and differs by whole or half tiles in others.
class WindowTints
{
public:
    explicit WindowTints(int size) : half_(size / 2) {}

    /// The tint of the window that a pixel at (x, y) of a tile shows.
    Rgb of(SourcePixel source, int x, int y)
    {
        const auto rest = [&](int offset) { return (offset % half_ + half_) % half_; };
        const auto found = numbers_.try_emplace({rest(source.x - x), rest(source.y - y)}, numbers_.size()).first;
        return tints[found->second % tints.size()];
    }

private:
    int half_;
    std::map<std::pair<int, int>, std::size_t> numbers_;
};

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

std::vector<std::uint8_t> piece_values(const TextureSet& set)
{
    std::vector<std::uint8_t> values;
    WindowTints window_tints(set.size);
    const auto size = static_cast<std::size_t>(set.size), channels = static_cast<std::size_t>(set.exemplar.channels);
    for (std::size_t i = 0; i < set.sources.size(); ++i) {
        const std::size_t in_tile = i % set.pixels_a_tile();
        Rgb color{};
        for (std::size_t c = 0; c < 3; ++c) color[c] = set.values[i * channels + std::min(c, channels - 1)];
        const Rgb tint =
            window_tints.of(set.sources[i], static_cast<int>(in_tile % size), static_cast<int>(in_tile / size));
        const Rgb mixed = tinted(color, tint);
        values.insert(values.end(), mixed.begin(), mixed.end());
    }
    return values;
}

PngPixels seam_picture(const TextureSet& set)
{
    constexpr Rgb red{255, 0, 0};
    const AtlasLayout layout = atlas_layout(set);
    PngPixels picture = enlarged(colored(atlas_of(set)), 2);
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile) {
        const auto sources = set.sources_of(tile);
        const auto source = [&](int x, int y) { return sources[static_cast<std::size_t>(y * set.size + x)]; };
        const int left = layout.places[tile].first * set.size, top = layout.places[tile].second * set.size;
        for (int y = 0; y < set.size; ++y)
            for (int x = 0; x < set.size; ++x) {
                const SourcePixel here = source(x, y);
                const bool east =
                    x + 1 < set.size && (source(x + 1, y).x != here.x + 1 || source(x + 1, y).y != here.y);
                const bool south =
                    y + 1 < set.size && (source(x, y + 1).y != here.y + 1 || source(x, y + 1).x != here.x);
                for (int i = 0; i < 2; ++i) {
                    if (east) put(picture, 2 * (left + x) + 1, 2 * (top + y) + i, red);
                    if (south) put(picture, 2 * (left + x) + i, 2 * (top + y) + 1, red);
                }
            }
    }
    return picture;
}

PngPixels window_picture(const PngPixels& exemplar, const std::vector<ExemplarWindow>& windows, std::size_t patches)
{
    PngPixels picture = colored(exemplar);
    for (std::size_t i = windows.size(); i-- > 0;)
        put_frame(picture, windows[i], i < patches ? tints[i % tints.size()] : Rgb{235, 235, 235}, i < patches ? 3 : 1);
    return picture;
}

PngPixels level_picture(const TexturePyramid& pyramid)
{
    const int width = pyramid.width(0);
    PngPixels picture = blank(width + width / 2, width);
    put_picture(picture, level_pixels(pyramid, 0), 0, 0);
    int top = 0;
    for (int level = 1; level <= pyramid.levels.top; ++level) {
        put_picture(picture, level_pixels(pyramid, level), width, top);
        top += pyramid.width(level);
    }
    return picture;
}

PngPixels step_map_picture(const StepMap& map)
{
    PngPixels picture{map.size, map.size, 1, {}};
    for (const double step : map.steps)
        picture.values.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(step * 127.5, 0.0, 255.0))));
    return enlarged(picture, std::max(1, 256 / map.size));
}

}
