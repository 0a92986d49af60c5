// Panels of several pieces or tiles, and of tilings.
#include "host/scenes/construction_panels.hpp"

#include "host/scenes/construction_parts.hpp"
#include "host/tile_construction/piece_store.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <variant>

namespace poissonlab {
namespace {

// Which Poisson tile lies where in a stochastic tiling.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.5: corner tiles as they are;
// edge-based tiles by the edges of a Wang tiling, of the tile and of its neighbours; template tiles at
// random.

class ConstructionTiling
{
public:
    /// 2D. Throws InputError for numbers of colours that tilings cannot have.
    explicit ConstructionTiling(const PoissonTileParameters& parameters);

    /// The number of the tile whose lower left corner is (x, y).
    std::uint32_t tile(std::int64_t x, std::int64_t y) const;

private:
    std::uint32_t edge_based_tile(const Tiling& wang, std::int64_t x, std::int64_t y) const;

    PoissonTileParameters parameters_;
    std::variant<Tiling, ColorHash> source_; ///< the hash function: of template tiles
};

std::variant<Tiling, ColorHash> source_of(const PoissonTileParameters& p)
{
    const WangColors colors{p.colors, p.colors};
    if (p.kind == PoissonTileKind::frame) return make_color_hash(HashKind::xxh64, p.tiles, p.seed);
    if (p.kind == PoissonTileKind::edge)
        return Tiling(DirectAlgorithm::wang_edge_hash, colors, HashKind::xxh64, p.seed);
    return Tiling(DirectAlgorithm::corner, colors, HashKind::xxh64, p.seed);
}

ConstructionTiling::ConstructionTiling(const PoissonTileParameters& parameters)
    : parameters_(parameters), source_(source_of(parameters))
{}

std::uint32_t ConstructionTiling::tile(std::int64_t x, std::int64_t y) const
{
    if (const auto* hash = std::get_if<ColorHash>(&source_))
        return std::visit([&](const auto& h) { return h(x, y); }, *hash);
    const Tiling& tiling = std::get<Tiling>(source_);
    return parameters_.kind == PoissonTileKind::edge ? edge_based_tile(tiling, x, y) : tiling.tile(x, y);
}

std::uint32_t ConstructionTiling::edge_based_tile(const Tiling& wang, std::int64_t x, std::int64_t y) const
{
    const auto at = [&](std::int64_t dx, std::int64_t dy) {
        return wang_tile(wang.tile(x + dx, y + dy), {parameters_.colors, parameters_.colors});
    };
    const WangTile own = at(0, 0), north = at(0, 1), east = at(1, 0), south = at(0, -1), west = at(-1, 0);
    return edge_tile_of({own.north, own.east, own.south, own.west, east.north, north.east, east.south, south.east,
                         west.south, south.west, west.north, north.west},
                        parameters_.colors);
}

class TileScene : PanelParts
{
public:
    using PanelParts::PanelParts;

    Scene make()
    {
        if (config_.is_tiling())
            add_tiling();
        else
            add_list();
        return std::move(scene_);
    }

private:
    // Several pieces or tiles.

    void add_list()
    {
        for (const auto& [axes, variant] : wanted_pieces(config_))
            scene_.panels.push_back(axes == all_axes(d_) ? listed_tile(variant) : listed_piece(axes, variant));
        scene_.columns = list_columns(scene_.panels.size());
    }

    /// Nearly square, a few in one row; narrow pieces ten in a row, wide ones four at most.
    std::size_t list_columns(std::size_t count) const
    {
        const bool is_wide = d_ == 2 && config_.axes == 1, is_narrow = d_ == 2 && config_.axes == 2;
        const auto root = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
        const std::size_t most = is_narrow ? 10
                                 : is_wide ? std::min<std::size_t>(4, root)
                                           : std::max<std::size_t>(4, root);
        const std::size_t rows = (count + most - 1) / most;
        return (count + rows - 1) / rows;
    }

    ScenePanel listed_piece(std::uint8_t axes, std::uint32_t variant) const
    {
        const MadePiece& made = made_piece(axes, variant);
        ScenePanel panel = new_panel();
        const RegionExtent extent = extent_of(axes);
        for (int k = 0; k < d_; ++k) {
            const bool is_own = axes >> k & 1;
            panel.window.low[k] = (is_own ? extent.end : -extent.reach) - panel_margin;
            panel.window.size[k] = (is_own ? tile_units - 2 * extent.end : 2 * extent.reach) + 2 * panel_margin;
        }
        panel.part = panel.window;
        panel.pieces.push_back(piece_at(axes, {}, variant));
        panel.pieces.back().is_made = true;
        panel.of(PointClass::inner) = cut_out(made.filled.active, regions_, axes, made.base, false);
        return panel;
    }

    /// The reach of a region across its cell, and the distance from the cell's ends at which it begins.
    struct RegionExtent
    {
        std::int32_t reach = 0;
        std::int32_t end = 0;
    };

    RegionExtent extent_of(std::uint8_t axes) const
    {
        const std::array<std::int32_t, 4> reaches{0, regions_.width, regions_.pair_one, regions_.corner_one};
        const auto across = static_cast<std::size_t>(d_ - std::popcount(axes));
        return {reaches[across], across < 3 ? reaches[across + 1] : 0};
    }

    ScenePanel listed_tile(std::uint32_t tile) const
    {
        const MadePiece& made = made_piece(all_axes(d_), tile);
        ScenePanel panel = tile_panel("");
        panel.pieces = pieces_of_a_tile(tile);
        panel.of(PointClass::held) = shown(made.problem.held, {}, panel.part);
        for (const TilePosition& point : made.filled.active)
            panel.of(cell_of(point).axes == all_axes(d_) ? PointClass::inner : PointClass::held).push_back(point);
        return panel;
    }

    // Tilings.

    void add_tiling()
    {
        const bool with_regions = config_.show == "tiling";
        const ConstructionTiling tiling(p_);
        const auto [x0, y0, width, height] = config_.window;
        ScenePanel panel = new_panel();
        panel.window.size = {static_cast<std::int32_t>(width) * tile_units,
                             static_cast<std::int32_t>(height) * tile_units, 0};
        panel.part = panel.window;
        std::set<std::pair<std::uint8_t, std::array<std::int32_t, 3>>> added;
        for (std::int32_t y = 0; y < static_cast<std::int32_t>(height); ++y)
            for (std::int32_t x = 0; x < static_cast<std::int32_t>(width); ++x) {
                const std::uint32_t tile = tiling.tile(x0 + x, y0 + y);
                add_points(panel, tile, {x, y, 0});
                if (!with_regions) continue;
                panel.tiles.push_back({x, y, 0});
                if (p_.border == TileBorder::chain) continue; // which have no regions
                // The tiles of a template have their own colours.
                if (p_.kind == PoissonTileKind::frame) panel.pieces.push_back({all_axes(d_), {x, y, 0}, {tile}, false});
                for (ScenePiece piece : pieces_of_a_tile(tile)) {
                    piece.base[0] += x;
                    piece.base[1] += y;
                    if (added.emplace(piece.axes, piece.base).second) panel.pieces.push_back(piece);
                }
            }
        scene_.panels.push_back(std::move(panel));
    }

    /// The points of a tile at a place.
    void add_points(ScenePanel& panel, std::uint32_t tile, const std::array<std::int32_t, 3>& place) const
    {
        const std::span<const std::uint16_t> points = made_.set.tile(tile);
        const StoredScale scale = stored_scale(p_.border);
        const auto at = [&](std::int32_t cell, std::uint16_t stored) {
            return cell * tile_units + scale.position(stored);
        };
        for (std::size_t i = 0; i < points.size(); i += 2)
            panel.of(PointClass::held).push_back({at(place[0], points[i]), at(place[1], points[i + 1]), 0});
    }
};

}

std::vector<PieceKey> wanted_pieces(const ShownConstruction& config)
{
    if (config.show == "master" || config.show == "template") return {{config.axes, 0}};
    if (config.is_stage()) return {{config.axes, config.variant}};
    std::vector<PieceKey> keys;
    if (!config.is_list()) return keys;
    // If there are many pieces, those shown are far from one another.
    const std::uint64_t all = piece_count(config.parameters, config.axes);
    for (std::uint64_t i = 0; i < config.count; ++i)
        keys.emplace_back(config.axes, static_cast<std::uint32_t>(i * all / config.count));
    return keys;
}

Scene make_scene(const ShownConstruction& config, const MadeTiles& made)
{
    if (config.is_set()) return set_scene(config);
    if (config.show == "regions" || config.show == "kinds") return region_scene(config, made);
    if (config.is_stage()) return stage_scene(config, made);
    return TileScene(config, made).make();
}

}
