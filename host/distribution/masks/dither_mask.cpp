#include "host/distribution/masks/dither_mask.hpp"

#include "base/files/npy_header.hpp"
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/images/png_file.hpp"
#include "base/random/random.hpp"
#include "host/distribution/masks/void_and_cluster.hpp"
#include "host/tile_construction/tile_ranking.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace poissonlab {
namespace {

/// Ranks the upper half anew, from above: above a high threshold there are as few pixels as below a low one, and they
/// are to be as even. `set` has ranks.
void rank_upper_half(PoissonTileSet& set, const std::function<void(std::size_t done, std::size_t total)>& progress)
{
    const std::uint32_t all = set.parameters.points_per_tile, lower = all / 2;
    PoissonTileSet upper;
    upper.parameters = set.parameters;
    upper.parameters.points_per_tile = all - lower;
    std::vector<std::size_t> places; // of its points among those of all
    for (std::size_t i = 0; i < set.ranks.size(); ++i) {
        if (set.ranks[i] < lower) continue;
        places.push_back(i);
        upper.points.push_back(set.points[2 * i]);
        upper.points.push_back(set.points[2 * i + 1]);
    }
    const std::vector<std::uint16_t> ranks = rank_points(upper, progress);
    for (std::size_t i = 0; i < places.size(); ++i)
        set.ranks[places[i]] = static_cast<std::uint16_t>(all - 1 - ranks[i]);
}

}

void write_dither_mask(const std::filesystem::path& file, const DitherMask& mask)
{
    const auto side = static_cast<int>(mask.size);
    if (file.extension() == ".npy")
        return write_whole_file(file, npy_header_of(fmt::format("'{}u4'", npy_byte_order()),
                                                    fmt::format("({}, {})", mask.size, mask.size)) +
                                          std::string(reinterpret_cast<const char*>(mask.ranks.data()),
                                                      mask.ranks.size() * sizeof(std::uint32_t)));
    if (mask.levels > 256) {
        DeepPixels pixels{side, side, 1, {}};
        for (std::size_t i = 0; i < mask.pixels(); ++i)
            pixels.values.push_back(static_cast<std::uint16_t>(mask.threshold(i, 65'536)));
        return write_deep_png(file, pixels);
    }
    std::vector<std::uint8_t> pixels;
    for (std::size_t i = 0; i < mask.pixels(); ++i) pixels.push_back(static_cast<std::uint8_t>(mask.threshold(i, 256)));
    write_png(file, {side, side, 1},
              [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * mask.size]; });
}

void write_threshold_strip(const std::filesystem::path& file, const DitherMask& mask)
{
    constexpr std::uint32_t shown = 4, gap = 8; // by as many
    const std::uint32_t part = std::min(mask.size, 128u), width = shown * part + (shown - 1) * gap;
    const std::uint32_t height = 2 * part + gap;
    std::vector<std::uint8_t> pixels(std::size_t{width} * height, 200);
    for (std::uint32_t i = 0; i < 2 * shown; ++i)
        for (std::uint32_t y = 0; y < part; ++y)
            for (std::uint32_t x = 0; x < part; ++x) {
                const bool is_below =
                    std::uint64_t{mask.ranks[std::size_t{y} * mask.size + x]} * 16 < std::uint64_t{i + 1} * mask.levels;
                pixels[std::size_t{y + i / shown * (part + gap)} * width + x + i % shown * (part + gap)] =
                    is_below ? 0 : 255;
            }
    write_png(file, {static_cast<int>(width), static_cast<int>(height), 1},
              [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * width]; });
}

PoissonTileSet dither_tiles(const DitherMaskSettings& settings, std::uint64_t seed, const OnPart& on_part)
{
    const std::uint32_t side = settings.tile_pixels;
    PoissonTileSet set;
    PoissonTileParameters& p = set.parameters;
    p.colors = settings.colors;
    p.tiles = tile_count(p.kind, p.dimension, p.colors);
    p.points_per_tile = side * side;
    p.ranked = true;
    p.seed = seed;
    // Neighbouring pixels are a pixel apart.
    const std::uint32_t step = tile_units / side;
    p.relative_radius = relative_radius(static_cast<double>(step) / tile_units, p.points_per_tile, 2) * (1 - 1e-9);
    set.squared_min_distance = std::uint64_t{step} * step;
    for (std::uint32_t tile = 0; tile < p.tiles; ++tile)
        for (std::uint32_t y = 0; y < side; ++y)
            for (std::uint32_t x = 0; x < side; ++x)
                for (const std::uint32_t at : {x, y})
                    set.points.push_back(static_cast<std::uint16_t>(at * step + step / 2));
    const auto told = [&](double from, double share) {
        return [&on_part, from, share](std::size_t done, std::size_t total) {
            if (on_part) on_part(from + share * static_cast<double>(done) / static_cast<double>(total));
        };
    };
    set.ranks = rank_points(set, told(0, 0.7));
    rank_upper_half(set, told(0.7, 0.3));
    return set;
}

DitherMask mask_of_tiles(const PoissonTileSet& tiles, std::uint32_t period, std::uint64_t seed)
{
    const std::uint32_t all = tiles.parameters.points_per_tile;
    std::uint32_t side = 1;
    while (side * side < all) ++side;
    const ptiles_tiling tiling =
        runtime_tiling(tiles, {stream_key(seed, Purpose::tile_choice, 0)[0], static_cast<std::int32_t>(period)});
    DitherMask mask{period * side, all, {}};
    mask.ranks.resize(std::size_t{mask.size} * mask.size);
    for (std::uint32_t j = 0; j < period; ++j)
        for (std::uint32_t i = 0; i < period; ++i) {
            const std::uint32_t tile =
                ptiles_tile(&tiling, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), 0);
            const std::uint16_t* ranks = &tiles.ranks[std::size_t{tile} * all];
            for (std::uint32_t point = 0; point < all; ++point) {
                // Tiles go up, rows of pictures down.
                const std::uint32_t row = mask.size - 1 - (j * side + point / side), column = i * side + point % side;
                mask.ranks[std::size_t{row} * mask.size + column] = ranks[point];
            }
        }
    return mask;
}

DitherMask dither_mask(const DitherMaskSettings& settings, std::uint64_t seed, const OnPart& on_part)
{
    if (settings.method == DitherMethod::tiles)
        return mask_of_tiles(dither_tiles(settings, seed, on_part), settings.size / settings.tile_pixels, seed);
    return {settings.size, settings.size * settings.size,
            void_and_cluster(settings.size, settings.size, seed, on_part)};
}

}
