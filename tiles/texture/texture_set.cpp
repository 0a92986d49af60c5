#include "tiles/texture/texture_set.hpp"

#include "tiles/packing/closed_packing.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

TileKind kind_of_index(const TextureSet& set) { return set.has_corners() ? TileKind::corner : TileKind::wang; }

/// Copies the rows of a tile's channels to its place in an atlas.
void copy_tile(const TextureSet& set, std::size_t tile, std::pair<int, int> place, PngPixels& atlas)
{
    const std::span<const std::uint8_t> values = set.values_of(tile);
    const std::size_t row_bytes = static_cast<std::size_t>(set.size) * static_cast<std::size_t>(atlas.channels);
    for (int row = 0; row < set.size; ++row)
        std::ranges::copy(values.subspan(static_cast<std::size_t>(row) * row_bytes, row_bytes),
                          atlas.values.begin() + static_cast<std::ptrdiff_t>(atlas.at(
                                                     place.first * set.size, place.second * set.size + row, 0)));
}

}

TileSet TextureSet::index_set() const
{
    std::vector<TileIndex> indices;
    for (const TextureTile& tile : tiles) indices.push_back(tile.index);
    std::ranges::sort(indices);
    const auto rest = std::ranges::unique(indices);
    indices.erase(rest.begin(), rest.end());
    return {kind_of_index(*this), colors, std::move(indices)};
}

bool TextureSet::is_complete() const
{
    const TileSet all = index_set();
    return all.is_complete() && all.size() == tiles.size();
}

AtlasLayout atlas_layout(const TextureSet& set)
{
    AtlasLayout layout;
    if (set.colors.horizontal == set.colors.vertical && set.is_complete()) {
        const Color colors = set.colors.horizontal, side = colors * colors;
        layout.columns = layout.rows = static_cast<int>(side);
        for (const TextureTile& tile : set.tiles) {
            const PackingPlace place = place_of_tile(kind_of_index(set), tile.index, colors);
            layout.places.emplace_back(static_cast<int>(place.x), static_cast<int>(side - 1 - place.y));
        }
        return layout;
    }
    const int count = static_cast<int>(set.tiles.size());
    while (layout.columns * layout.columns < count) ++layout.columns;
    layout.rows = (count + layout.columns - 1) / layout.columns;
    for (int tile = 0; tile < count; ++tile) layout.places.emplace_back(tile % layout.columns, tile / layout.columns);
    return layout;
}

bool has_places(const TextureSet& set)
{
    return set.kind != TextureKind::omega && set.colors.horizontal == set.colors.vertical && set.is_complete();
}

PngPixels atlas_of(const TextureSet& set)
{
    const AtlasLayout layout = atlas_layout(set);
    PngPixels atlas{layout.columns * set.size, layout.rows * set.size, set.exemplar.channels, {}};
    atlas.values.resize(atlas.at(0, atlas.height, 0));
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile) copy_tile(set, tile, layout.places[tile], atlas);
    return atlas;
}

}
