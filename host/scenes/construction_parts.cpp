#include "host/scenes/construction_parts.hpp"

#include "tiles/poisson/tile_pieces.hpp"

#include <algorithm>
#include <bit>

namespace poissonlab {
namespace {

/// The colours that a piece's region is drawn in: of the corners of its cell; of edge-based sets those of its
/// edge, or of the edges that leave it north, east, south and west.
std::vector<std::uint32_t> colors_of(const PoissonTileParameters& p, std::uint8_t axes, std::uint32_t variant)
{
    if (p.kind == PoissonTileKind::frame) return {};
    if (axes == all_axes(p.dimension)) return {};
    const bool is_edge_based = p.kind == PoissonTileKind::edge;
    std::vector<std::uint32_t> colors(is_edge_based ? (axes == 0 ? 4 : 1) : std::size_t{1} << std::popcount(axes));
    for (std::uint32_t& color : colors) {
        color = variant % p.colors;
        variant /= p.colors;
    }
    if (is_edge_based) std::ranges::reverse(colors);
    return colors;
}

}

SceneBox box_around(const TileRegions& regions, std::uint8_t axes, std::int32_t reach)
{
    SceneBox box;
    for (int k = 0; k < regions.dimension; ++k) {
        const bool is_own = axes >> k & 1;
        box.low[k] = -reach;
        box.size[k] = 2 * reach + (is_own ? tile_units : 0);
    }
    return box;
}

PanelParts::PanelParts(const ShownConstruction& config, const MadeTiles& made)
    : config_(config), made_(made), p_(config.parameters), d_(p_.dimension), regions_(regions_of(p_))
{
    scene_.dimension = d_;
    scene_.width = regions_.width;
    scene_.radius = asked_min_distance(p_) / 2 * tile_units;
}

ScenePanel PanelParts::new_panel() const
{
    ScenePanel panel;
    panel.modified = config_.modified && p_.kind != PoissonTileKind::frame;
    return panel;
}

ScenePanel PanelParts::tile_panel(const std::string& caption) const
{
    ScenePanel panel = new_panel();
    panel.caption = caption;
    panel.part = box_around(regions_, all_axes(d_), 0);
    panel.window = box_around(regions_, all_axes(d_), panel_margin);
    panel.tiles.push_back({});
    return panel;
}

ScenePiece PanelParts::piece_at(std::uint8_t axes, const std::array<std::int32_t, 3>& base, std::uint32_t variant) const
{
    return {axes, base, colors_of(p_, axes, variant), false};
}

std::vector<ScenePiece> PanelParts::pieces_of_a_tile(std::uint32_t tile) const
{
    std::vector<ScenePiece> pieces;
    for (const PlacedPiece& piece : pieces_around(p_, tile))
        pieces.push_back(piece_at(piece.axes, {piece.base[0], piece.base[1], piece.base[2]}, piece.variant));
    return pieces;
}

const MadePiece& PanelParts::made_piece(std::uint8_t axes, std::uint32_t variant) const
{
    return made_.pieces.at({axes, variant});
}

std::vector<TilePosition> PanelParts::shown(std::span<const TilePosition> points,
                                            const std::array<std::int8_t, 3>& base, const SceneBox& window) const
{
    std::vector<TilePosition> result;
    for (const TilePosition& point : points) {
        TilePosition place{};
        for (int k = 0; k < d_; ++k)
            place[k] =
                window.low[k] + wrapped(point[k] - base[static_cast<std::size_t>(k)] * tile_units - window.low[k]);
        if (window.holds(place, d_)) result.push_back(place);
    }
    return result;
}

ScenePiece PanelParts::cell_of(const TilePosition& position) const
{
    std::array<std::uint16_t, 3> in_tile{};
    ScenePiece cell;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d_); ++k) {
        in_tile[k] = static_cast<std::uint16_t>(position[k] & (tile_units - 1));
        cell.base[k] = position[k] >> tile_bits;
    }
    const TileCell found = regions_.cell_of(std::span(in_tile).first(static_cast<std::size_t>(d_)));
    cell.axes = found.axes;
    for (std::size_t k = 0; k < 3; ++k) cell.base[k] += found.upper >> k & 1;
    return cell;
}

}
