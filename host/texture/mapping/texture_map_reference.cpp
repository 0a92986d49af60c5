// The plain C++ twin of kernels/textures/texture_map.cl: a loop over pixels, samples and texels, each of which finds
// its own tile.
#include "host/texture/mapping/seen_place.hpp"
#include "host/texture/mapping/texture_map.hpp"
#include "tiles/texture/endless_texture.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using namespace contract::texture_map;

/// The place of a texel: its tile, relative to the view's, and its column and row there.
struct Texel
{
    std::int32_t tile_x = 0, tile_y = 0;
    int column = 0, row = 0;
};

class PlainMap
{
public:
    PlainMap(const TexturePyramid& pyramid, TextureLookup lookup, const TextureView& view)
        : pyramid_(pyramid), levels_(pyramid.levels), lookup_(lookup), view_(view),
          side_(levels_.colors * levels_.colors)
    {}

    void add_sample(double column, double row, Light& sum) const
    {
        const std::optional<SeenPlace> seen = seen_place(view_, levels_.size, column, row);
        if (!seen) return add(static_cast<float>(SKY_LIGHT), sum);
        if (view_.filter < FILTER_MIPMAP) return add_level(0, seen->u, seen->v, 1, sum);
        for (int probe = 0; probe < seen->probes; ++probe) {
            const auto [u, v] = probe_place(*seen, probe);
            add_mipmap(seen->texels, u, v, static_cast<float>(1.0 / seen->probes), sum);
        }
    }

private:
    void add(float light, Light& sum) const
    {
        for (int c = 0; c < pyramid_.channels; ++c) sum[static_cast<std::size_t>(c)] += light;
    }

    void add_stored(std::size_t first, float weight, Light& sum) const
    {
        for (std::size_t c = 0; c < static_cast<std::size_t>(pyramid_.channels); ++c)
            sum[c] += weight * pyramid_.light[first + c];
    }

    void add_mipmap(double footprint, double u, double v, float weight, Light& sum) const
    {
        const auto [level, upper] = levels_of_footprint(footprint, levels_.top + WHOLE_LEVELS + 1);
        add_level(level, u, v, weight * (1 - upper), sum);
        add_level(level + 1, u, v, weight * upper, sum);
    }

    void add_level(int level, double u, double v, float weight, Light& sum) const
    {
        if (weight == 0) return;
        if (lookup_ != TextureLookup::exact) level = std::min(level, levels_.top);
        if (level > levels_.top + WHOLE_LEVELS) return add_stored(levels_.offsets[levels_.top + 1], weight, sum);
        // Beyond a tile's own levels, a block of tiles takes the tile's place, and has one texel.
        const int block = level > levels_.top ? 1 << (level - levels_.top) : 1;
        const int size = level > levels_.top ? 1 : levels_.size >> level;
        Texel texel{static_cast<std::int32_t>(std::floor(u)), static_cast<std::int32_t>(std::floor(v))};
        const auto in_x = static_cast<int>((view_.tile_x + static_cast<std::uint32_t>(texel.tile_x)) %
                                           static_cast<std::uint32_t>(block)),
                   in_y = static_cast<int>((view_.tile_y + static_cast<std::uint32_t>(texel.tile_y)) %
                                           static_cast<std::uint32_t>(block));
        const double fx = u - std::floor(u), fy = v - std::floor(v);
        if (view_.filter == FILTER_NEAREST) {
            texel.column = static_cast<int>(fx * size);
            texel.row = static_cast<int>(fy * size);
            return add_texel(level, texel, weight, sum);
        }
        const double x = (in_x + fx) / block * size - 0.5, y = (in_y + fy) / block * size - 0.5;
        const auto west = static_cast<int>(std::floor(x)), south = static_cast<int>(std::floor(y));
        const auto east = static_cast<float>(x - west), north = static_cast<float>(y - south);
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i) {
                const float share = (i == 1 ? east : 1 - east) * (j == 1 ? north : 1 - north);
                if (level > levels_.top)
                    add_block({texel.tile_x - in_x + (west + i) * block, texel.tile_y - in_y + (south + j) * block},
                              block, weight * share, sum);
                else
                    add_texel(level, {texel.tile_x, texel.tile_y, west + i, south + j}, weight * share, sum);
            }
    }

    std::uint32_t place_of(std::int32_t x, std::int32_t y) const
    {
        return endless_place(pyramid_.is_wang ? TileKind::wang : TileKind::corner, levels_.seed,
                             static_cast<Color>(levels_.colors), view_.tile_x + static_cast<std::uint32_t>(x),
                             view_.tile_y + static_cast<std::uint32_t>(y));
    }

    void add_block(Texel corner, int block, float weight, Light& sum) const
    {
        Light mean{};
        for (int row = 0; row < block; ++row)
            for (int column = 0; column < block; ++column)
                add_atlas_texel(levels_.top, place_of(corner.tile_x + column, corner.tile_y + row), 0, 0, 1, mean);
        for (std::size_t c = 0; c < mean.size(); ++c)
            sum[c] += weight * static_cast<float>(1.0 / (block * block)) * mean[c];
    }

    /// Adds the texel by column and row from the lower left of a tile in the atlas, which goes on at its other side.
    void add_atlas_texel(int level, std::uint32_t place, int column, int row, float weight, Light& sum) const
    {
        const int size = levels_.size >> level, width = side_ * size;
        const int x = (static_cast<int>(place) % side_ * size + column + width) % width,
                  y = (static_cast<int>(place) / side_ * size + row + width) % width;
        add_stored(levels_.offsets[level] + static_cast<std::size_t>((y * width + x) * pyramid_.channels), weight, sum);
    }

    void add_texel(int level, Texel texel, float weight, Light& sum) const
    {
        const int size = levels_.size >> level;
        const auto beyond = [&](int at) { return at < 0 ? -1 : at >= size ? 1 : 0; };
        switch (lookup_) {
        case TextureLookup::packed:
            break;
        case TextureLookup::exact:
            texel.tile_x += beyond(texel.column);
            texel.tile_y += beyond(texel.row);
            texel.column -= beyond(texel.column) * size;
            texel.row -= beyond(texel.row) * size;
            break;
        case TextureLookup::clamped:
            texel.column = std::clamp(texel.column, 0, size - 1);
            texel.row = std::clamp(texel.row, 0, size - 1);
            break;
        case TextureLookup::repeated: {
            const auto wrapped = [&](std::uint32_t origin, std::int32_t tile) {
                const int at = (tile + static_cast<std::int32_t>(origin)) % side_;
                return at < 0 ? at + side_ : at;
            };
            const int place = wrapped(view_.tile_y, texel.tile_y) * side_ + wrapped(view_.tile_x, texel.tile_x);
            return add_atlas_texel(level, static_cast<std::uint32_t>(place), texel.column, texel.row, weight, sum);
        }
        }
        add_atlas_texel(level, place_of(texel.tile_x, texel.tile_y), texel.column, texel.row, weight, sum);
    }

    const TexturePyramid& pyramid_;
    const TextureLevels& levels_;
    TextureLookup lookup_;
    const TextureView& view_;
    int side_;
};

}

std::vector<float> reference_map_texture(const TexturePyramid& pyramid, TextureLookup lookup, const TextureView& view)
{
    const PlainMap map(pyramid, lookup, view);
    return plain_picture(view, pyramid.channels,
                         [&](double column, double row, Light& sum) { map.add_sample(column, row, sum); });
}

}
