#include "host/distribution/textures/texture_pictures.hpp"

#include "host/distribution/textures/painting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace poissonlab {
namespace {

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
