#include "host/settings/tilings/aperiodic_tiles.hpp"

#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/beatty_tiling.hpp"
#include "tiles/aperiodic/constructed_tilings.hpp"

#include <algorithm>
#include <optional>

namespace poissonlab {
namespace {

/// A word taken apart.
struct AperiodicName
{
    std::string set;
    std::optional<CornerConstruction> construction{};
};

AperiodicName aperiodic_name(const std::string& word)
{
    for (const std::string& set : aperiodic_set_names()) {
        if (word == set) return {set};
        if (word.starts_with(set + "-"))
            if (const auto construction = corner_constructions.find(word.substr(set.size() + 1)))
                return {set, construction};
    }
    return {};
}

std::vector<std::string> aperiodic_words(TileKind kind, bool has_tiling)
{
    std::vector<std::string> words;
    for (const std::string& set : aperiodic_set_names()) {
        if (has_tiling && (set == "robinson" || set == "jeandel-rao")) continue; // by search only, which has no places
        if (kind == TileKind::wang) words.push_back(set);
        if (kind != TileKind::corner) continue;
        for (const std::string& construction : corner_constructions.all()) words.push_back(set + "-" + construction);
    }
    return words;
}

/// The index of a tile with the same number of colours everywhere.
TileIndex index_of(const WangTile& tile, Color colors) { return wang_index(tile, {colors, colors}); }
TileIndex index_of(const CornerTile& tile, Color colors) { return corner_index(tile, colors); }

template <class Tile>
std::vector<TileIndex> indices_of(const std::vector<Tile>& tiles, Color colors)
{
    std::vector<TileIndex> indices;
    for (const Tile& tile : tiles) indices.push_back(index_of(tile, colors));
    return indices;
}

struct AperiodicTiles
{
    Color colors = 0;
    std::vector<TileIndex> indices; ///< in the order of the set
};

AperiodicTiles aperiodic_tiles(const AperiodicName& name)
{
    const WangList wang = find_aperiodic_set(name.set)->tiles();
    if (!name.construction) return {color_count(wang), indices_of(wang.tiles, color_count(wang))};
    const CornerList corners = construct_corners(wang, *name.construction).list;
    return {corners.colors, indices_of(corners.tiles, corners.colors)};
}

WindowMaker window_maker(const std::string& set, std::uint64_t seed)
{
    if (set == "ammann") return [seed](const TileWindow& window) { return ammann_tiles_of(window, seed); };
    return [tiling = BeattyTiling(set == "kari" ? BeattySet::kari : BeattySet::culik, seed)](const TileWindow& window) {
        const auto tiles = reference::beatty_tiles(tiling, window);
        return std::vector<ListPlace>(tiles.begin(), tiles.end());
    };
}

}

const std::vector<std::string>& aperiodic_set_words(TileKind kind)
{
    static const std::vector<std::string> wang = aperiodic_words(TileKind::wang, false);
    static const std::vector<std::string> corner = aperiodic_words(TileKind::corner, false);
    static const std::vector<std::string> none;
    return kind == TileKind::wang ? wang : kind == TileKind::corner ? corner : none;
}

const std::vector<std::string>& aperiodic_tiling_words(TileKind kind)
{
    static const std::vector<std::string> wang = aperiodic_words(TileKind::wang, true);
    static const std::vector<std::string> corner = aperiodic_words(TileKind::corner, true);
    static const std::vector<std::string> none;
    return kind == TileKind::wang ? wang : kind == TileKind::corner ? corner : none;
}

bool is_aperiodic_word(TileKind kind, const std::string& word)
{
    return std::ranges::find(aperiodic_set_words(kind), word) != aperiodic_set_words(kind).end();
}

Color aperiodic_colors(const std::string& word) { return aperiodic_tiles(aperiodic_name(word)).colors; }

TileSet aperiodic_tile_set(TileKind kind, const std::string& word)
{
    AperiodicTiles tiles = aperiodic_tiles(aperiodic_name(word));
    return {kind, {tiles.colors, tiles.colors}, std::move(tiles.indices)};
}

std::vector<TileIndex> aperiodic_window(const std::string& word, std::uint64_t seed, const TileWindow& window)
{
    const AperiodicName name = aperiodic_name(word);
    const WindowMaker maker = window_maker(name.set, seed);
    std::vector<ListPlace> places;
    if (name.construction) {
        const WangList wang = find_aperiodic_set(name.set)->tiles();
        const CornerList corners = construct_corners(wang, *name.construction).list;
        places = corner_tiles_of(wang, corners, *name.construction, window, maker);
    } else {
        places = maker(window);
    }
    const AperiodicTiles tiles = aperiodic_tiles(name);
    std::vector<TileIndex> indices;
    for (const ListPlace place : places) indices.push_back(tiles.indices[place]);
    return indices;
}

}
