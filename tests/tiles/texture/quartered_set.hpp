// A texture set whose tiles are quarters of patches, cut nowhere.
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <utility>
#include <vector>

namespace poissonlab::test {

/// All corner tiles over the colours, with the patch of each colour in the exemplar by its upper left corner.
inline TextureSet quartered_set(PngPixels exemplar, int size, const std::vector<std::pair<int, int>>& patches)
{
    TextureSet set;
    const auto colors = static_cast<Color>(patches.size());
    set.colors = {colors, colors};
    set.size = size;
    set.ring = 1;
    set.exemplar = std::move(exemplar);
    set.parameters = {{"made", "by hand"}};
    for (TileIndex index = 0; index < colors * colors * colors * colors; ++index) {
        set.tiles.push_back({index, 0});
        const CornerTile t = corner_tile(index, colors);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const bool is_west = x < size / 2, is_north = y < size / 2;
                const Color color =
                    is_north ? (is_west ? t.north_west : t.north_east) : (is_west ? t.south_west : t.south_east);
                const int px = patches[color].first + x + (is_west ? size / 2 : -size / 2);
                const int py = patches[color].second + y + (is_north ? size / 2 : -size / 2);
                set.sources.push_back({static_cast<std::uint16_t>(px), static_cast<std::uint16_t>(py)});
                for (int c = 0; c < set.exemplar.channels; ++c)
                    set.values.push_back(set.exemplar.values[set.exemplar.at(px, py, c)]);
            }
    }
    return set;
}

}
