#include "experiment/construction_panels.hpp"

#include "experiment/construction_tiling.hpp"
#include "tile_construction/boundary_stages.hpp"
#include "tile_construction/piece_store.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

namespace poissonlab {
namespace {

constexpr std::int32_t margin = tile_units / 20; // around what is shown

/// The colours that a piece's region is drawn in: of the corners of its cell; of edge-based sets those of its
/// edge, or of the edges that leave it north, east, south and west.
std::vector<std::uint32_t> colors_of(const PoissonTileParameters& p, std::uint8_t axes, std::uint32_t variant)
{
    if (p.kind == PoissonTileKind::frame) return {};
    if (axes == all_axes(p.dimension)) return {};
    const bool is_edge_based = p.kind == PoissonTileKind::edge;
    std::vector<std::uint32_t> colors(is_edge_based ? (axes == 0 ? 4 : 1)
                                                    : std::size_t{1} << std::popcount(axes));
    for (std::uint32_t& color : colors) {
        color = variant % p.colors;
        variant /= p.colors;
    }
    if (is_edge_based) std::ranges::reverse(colors);
    return colors;
}

/// A box around the whole region of a cell at the origin, or of a tile, with what lies at its ends.
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

class ScenePanels
{
public:
    ScenePanels(const ConstructionConfig& config, const MadeTiles& made)
        : config_(config), made_(made), p_(config.parameters), d_(p_.dimension), regions_(regions_of(p_))
    {
        scene_.dimension = d_;
        scene_.width = regions_.width;
        scene_.radius = asked_min_distance(p_) / 2 * tile_units;
    }

    Scene make()
    {
        const std::string& show = config_.show;
        if (show == "regions")
            d_ == 2 ? add_plane_regions() : add_space_regions();
        else if (show == "kinds")
            add_kinds();
        else if (config_.is_tiling())
            add_tiling();
        else if (config_.is_list())
            add_list();
        else if (show == "master")
            add_master();
        else if (show == "template")
            add_template();
        else if (config_.axes == all_axes(d_))
            add_tile_stages();
        else
            add_piece_stages();
        return std::move(scene_);
    }

private:
    // Regions alone.

    ScenePanel new_panel() const
    {
        ScenePanel panel;
        panel.modified = config_.modified && p_.kind != PoissonTileKind::frame;
        return panel;
    }

    /// A tile with its border.
    ScenePanel tile_panel(const std::string& caption) const
    {
        ScenePanel panel = new_panel();
        panel.caption = caption;
        panel.part = box_around(regions_, all_axes(d_), 0);
        panel.window = box_around(regions_, all_axes(d_), margin);
        panel.tiles.push_back({});
        return panel;
    }

    ScenePiece piece_at(std::uint8_t axes, const std::array<std::int32_t, 3>& base,
                        std::uint32_t variant) const
    {
        return {axes, base, colors_of(p_, axes, variant), false};
    }

    std::vector<ScenePiece> pieces_of_a_tile(std::uint32_t tile) const
    {
        std::vector<ScenePiece> pieces;
        for (const PlacedPiece& piece : pieces_around(p_, tile))
            pieces.push_back(
                piece_at(piece.axes, {piece.base[0], piece.base[1], piece.base[2]}, piece.variant));
        return pieces;
    }

    /// Both kinds of regions side by side: each in a scene of its own would be drawn to another scale.
    void add_plane_regions()
    {
        scene_.columns = 2;
        for (const bool modified : {false, true}) {
            ScenePanel panel =
                tile_panel(modified ? "The modified regions: corner regions are enlarged such that edge "
                                      "regions are two radii apart."
                                    : "Strips of the radius' width: corner regions, edge regions, and "
                                      "the interior.");
            panel.modified = modified;
            panel.pieces = pieces_of_a_tile(shown_tile());
            panel.pieces.push_back(piece_at(all_axes(d_), {}, 0));
            scene_.panels.push_back(panel);
        }
    }

    /// All its corners, edges and faces have different colours where there are enough.
    std::uint32_t shown_tile() const
    {
        const std::uint32_t c = p_.colors;
        if (p_.kind == PoissonTileKind::edge) return edge_tile_of({0, 1 % c, 2 % c, 3 % c}, c);
        std::array<std::uint32_t, 8> corners{};
        for (std::uint32_t k = 0; k < 8; ++k) corners[k] = d_ == 2 ? k % c : std::popcount(k) % c;
        return corner_tile_of(corners, d_, c);
    }

    void add_space_regions()
    {
        scene_.columns = 3;
        scene_.is_solid = true;
        const std::vector<ScenePiece> around = pieces_of_a_tile(shown_tile());
        const ScenePiece interior = piece_at(all_axes(d_), {}, 0);
        const std::array<const char*, 4> names{"The corner regions.", "The edge regions.",
                                               "The face regions.", "The interior region."};
        for (int count = 0; count <= 3; ++count) {
            ScenePanel panel = tile_panel(names[static_cast<std::size_t>(count)]);
            for (const ScenePiece& piece : around)
                if (std::popcount(piece.axes) == count) panel.pieces.push_back(piece);
            if (count == 3) panel.pieces.push_back(interior);
            scene_.panels.push_back(panel);
        }
        ScenePanel whole = tile_panel("The assembled tile.");
        whole.pieces = around;
        whole.pieces.push_back(interior);
        scene_.panels.push_back(whole);
        // Without what is at the corner that is nearest to the viewer, who is in the south-east and above.
        ScenePanel partly = whole;
        partly.caption = "The partially assembled tile.";
        std::erase_if(partly.pieces, [&](const ScenePiece& piece) {
            if (piece.axes == all_axes(d_)) return false;
            const std::array<std::int32_t, 3> nearest{1, 0, 1};
            for (std::size_t k = 0; k < 3; ++k)
                if (!(piece.axes >> k & 1) && piece.base[k] != nearest[k]) return false;
            return true;
        });
        scene_.panels.push_back(partly);
    }

    /// The whole tiles of the tiling of regions: a corner tile, and one edge and face tile of each direction.
    void add_kinds()
    {
        scene_.columns = 4;
        scene_.is_solid = true;
        const std::array<const char*, 4> names{"Corner tiles: great rhombicuboctahedra.", "Edge tiles.",
                                               "Face tiles.", "Interior tiles."};
        for (int count = 0; count <= 3; ++count) {
            ScenePanel panel = new_panel();
            panel.caption = names[static_cast<std::size_t>(count)];
            // Pieces begin at the origin, apart from one another by the corners and edges that are left out.
            const std::array<std::int32_t, 4> lows{regions_.corner_one, regions_.pair_one, regions_.width, 0};
            const std::array<std::int32_t, 4> highs{regions_.corner_one, tile_units - regions_.corner_one,
                                                    tile_units - regions_.pair_one, tile_units};
            for (std::size_t k = 0; k < 3; ++k) {
                panel.window.low[k] = -lows[static_cast<std::size_t>(count)];
                panel.window.size[k] = highs[static_cast<std::size_t>(count)] - panel.window.low[k];
            }
            panel.part = panel.window;
            const std::uint32_t two_colors = p_.colors; // of two corners: 0 and 1
            for (std::uint8_t axes = 0; axes <= all_axes(d_); ++axes)
                if (std::popcount(axes) == count)
                    panel.pieces.push_back(piece_at(axes, {}, count == 0 ? 0 : two_colors));
            scene_.panels.push_back(panel);
        }
    }

    // Stages of a piece.

    const MadePiece& made_piece(std::uint8_t axes, std::uint32_t variant) const
    {
        return made_.pieces.at({axes, variant});
    }

    /// The whole torus in 2D. In 3D the piece and the pieces at its ends: more would hide them.
    SceneBox stage_window() const
    {
        if (d_ == 3) return box_around(regions_, config_.axes, regions_.corner_one + margin);
        SceneBox box;
        for (int k = 0; k < d_; ++k) {
            box.low[k] = (config_.axes >> k & 1 ? tile_units / 2 : 0) - tile_units;
            box.size[k] = torus_units;
        }
        return box;
    }

    /// Points of a torus relative to a cell of it, those that the window shows.
    std::vector<TilePosition> shown(std::span<const TilePosition> points,
                                    const std::array<std::int8_t, 3>& base, const SceneBox& window) const
    {
        std::vector<TilePosition> result;
        for (const TilePosition& point : points) {
            TilePosition place{};
            for (int k = 0; k < d_; ++k)
                place[k] = window.low[k] +
                           wrapped(point[k] - base[static_cast<std::size_t>(k)] * tile_units - window.low[k]);
            if (window.holds(place, d_)) result.push_back(place);
        }
        return result;
    }

    /// Pieces of a torus relative to a cell of it, wherever the window shows them.
    std::vector<ScenePiece> shown_pieces(std::span<const PlacedPiece> pieces,
                                         const std::array<std::int8_t, 3>& base, const SceneBox& window) const
    {
        std::vector<ScenePiece> result;
        for (const PlacedPiece& piece : pieces)
            for (int turn = 0; turn < (d_ == 2 ? 9 : 27); ++turn) {
                const std::array<std::int32_t, 3> turns{turn % 3 - 1, turn / 3 % 3 - 1,
                                                        d_ == 2 ? 0 : turn / 9 - 1};
                std::array<std::int32_t, 3> place{};
                bool is_seen = true;
                for (std::size_t k = 0; k < static_cast<std::size_t>(d_); ++k) {
                    place[k] = piece.base[k] - base[k] + 2 * turns[k];
                    const bool is_own = piece.axes >> k & 1;
                    const std::int32_t reach = is_own ? 0 : tile_units / 2;
                    const std::int32_t low = place[k] * tile_units - reach;
                    const std::int32_t high = (place[k] + (is_own ? 1 : 0)) * tile_units + reach;
                    is_seen = is_seen && high > window.low[k] && low < window.low[k] + window.size[k];
                }
                if (is_seen) result.push_back(piece_at(piece.axes, place, piece.variant));
            }
        return result;
    }

    void add_piece_stages()
    {
        scene_.columns = 2;
        const MadePiece& made = made_piece(config_.axes, config_.variant);
        const std::string name = config_.show + " tile";
        ScenePanel empty = new_panel();
        empty.window = empty.part = stage_window();
        ScenePiece own = piece_at(config_.axes, {}, config_.variant);
        own.is_made = true;
        const std::string where = d_ == 2 ? "." : "; here what is near the tile.";

        ScenePanel assembled = empty;
        const std::vector<PlacedPiece> neighbours = earlier_neighbours(p_, config_.axes, config_.variant);
        assembled.caption = neighbours.empty()
                                ? "The " + name + "."
                                : "The " + name + " with the tiles at its ends, which are there already.";
        for (const PlacedPiece& piece : neighbours)
            assembled.pieces.push_back(
                piece_at(piece.axes, {piece.base[0], piece.base[1], piece.base[2]}, piece.variant));
        assembled.of(PointClass::held) =
            near(shown(made.problem.held, made.base, empty.window), assembled.pieces);
        assembled.pieces.push_back(own);
        scene_.panels.push_back(assembled);

        ScenePanel torus = empty;
        if (d_ == 2)
            torus.pieces = shown_pieces(made.held, made.base, empty.window);
        else
            torus.pieces = assembled.pieces;
        torus.of(PointClass::held) = shown(made.problem.held, made.base, empty.window);
        if (d_ == 2) torus.pieces.push_back(own);
        ScenePanel thrown = torus, relaxed = torus, cut = empty;
        thrown.caption = "Dart throwing fills the torus" + where;
        relaxed.caption = "Relaxation moves the points that are not held.";
        cut.caption = "The " + name + " is cut out.";
        add_free(thrown, made.filled.thrown, made.base);
        add_free(relaxed, made.filled.active, made.base);
        add_free(cut, made.filled.active, made.base);
        cut.of(PointClass::outer).clear();
        cut.pieces = {own};
        for (const ScenePanel& panel : {thrown, relaxed, cut}) scene_.panels.push_back(panel);
    }

    /// The cell whose region a position is in, of the unbounded lattice.
    ScenePiece cell_of(const TilePosition& position) const
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

    /// The points in the regions of some pieces.
    std::vector<TilePosition> near(std::vector<TilePosition> points,
                                   const std::vector<ScenePiece>& pieces) const
    {
        std::erase_if(points, [&](const TilePosition& point) {
            const ScenePiece cell = cell_of(point);
            return std::ranges::none_of(pieces, [&](const ScenePiece& piece) {
                return piece.axes == cell.axes && piece.base == cell.base;
            });
        });
        return points;
    }

    /// Points of a torus that are not held, by whether they are in the piece that is made.
    void add_free(ScenePanel& panel, std::span<const TilePosition> points,
                  const std::array<std::int8_t, 3>& base) const
    {
        for (const TilePosition& point : shown(points, base, panel.window)) {
            const ScenePiece cell = cell_of(point);
            const bool is_inner = cell.axes == config_.axes && cell.base == std::array<std::int32_t, 3>{};
            panel.of(is_inner ? PointClass::inner : PointClass::outer).push_back(point);
        }
    }

    // Stages of a tile.

    /// How far around a tile there are points while its interior is made.
    std::int32_t surroundings_margin() const
    {
        return std::max(regions_.pair_one,
                        std::min(tile_units / 2 - margin, surrounding_radii * regions_.width));
    }

    void add_tile_stages()
    {
        const MadePiece& made = made_piece(config_.axes, config_.variant);
        ScenePanel empty = tile_panel("");
        if (p_.kind != PoissonTileKind::frame) {
            empty.window = d_ == 3 ? box_around(regions_, config_.axes, regions_.corner_one + margin)
                                   : box_around(regions_, config_.axes, surroundings_margin() + margin);
            empty.part = empty.window;
        }
        ScenePanel assembled = empty;
        assembled.pieces = pieces_of_a_tile(config_.variant);
        assembled.pieces.push_back(piece_at(config_.axes, {}, config_.variant));
        assembled.pieces.back().is_made = true;
        assembled.of(PointClass::held) = shown(made.problem.held, {}, assembled.part);
        assembled.caption = p_.kind == PoissonTileKind::frame
                                ? "The tile template."
                                : "The interior with the tiles around it, which are there already.";
        scene_.panels.push_back(assembled);
        if (d_ == 3) scene_.panels.push_back(without_far_points(assembled));

        ScenePanel thrown = scene_.panels.back();
        thrown.of(PointClass::inner) = shown(made.filled.thrown, {}, thrown.part);
        thrown.caption = "Dart throwing fills the interior.";
        if (d_ == 3) scene_.panels.push_back(thrown);
        thrown.of(PointClass::surroundings) = shown(made.filled.surroundings, {}, thrown.part);
        if (d_ == 3)
            thrown.caption =
                "Dart throwing fills the exterior, so that relaxation does not draw points there.";
        else if (!thrown.of(PointClass::surroundings).empty())
            thrown.caption =
                "Dart throwing fills the interior, and what is around the tile, so that relaxation does "
                "not draw points there.";
        scene_.panels.push_back(thrown);

        ScenePanel relaxed = thrown;
        relaxed.of(PointClass::inner) = shown(made.filled.active, {}, relaxed.part);
        relaxed.caption = "Relaxation moves the points of the interior.";
        scene_.panels.push_back(relaxed);
        if (p_.kind != PoissonTileKind::frame) scene_.panels.push_back(cut_out_tile(relaxed));
        scene_.columns = d_ == 3 || p_.kind == PoissonTileKind::frame ? 3 : 2;
    }

    /// Held points that are more than two radii from the tile, which none of its points can feel, are left
    /// out.
    ScenePanel without_far_points(ScenePanel panel) const
    {
        panel.caption = "The points within two radii of the tile, all that its points can come near to.";
        std::erase_if(panel.of(PointClass::held), [&](const TilePosition& point) {
            double squared = 0;
            for (std::size_t k = 0; k < static_cast<std::size_t>(d_); ++k) {
                const std::int32_t outside = std::max({0, -point[k], point[k] - tile_units});
                squared += static_cast<double>(outside) * outside;
            }
            return squared > 4 * scene_.radius * scene_.radius;
        });
        return panel;
    }

    ScenePanel cut_out_tile(ScenePanel panel) const
    {
        panel.caption = "The tile is cut out.";
        panel.part = box_around(regions_, all_axes(d_), 0);
        panel.of(PointClass::surroundings).clear();
        std::erase_if(panel.of(PointClass::held),
                      [&](const TilePosition& point) { return !panel.part.holds(point, d_); });
        return panel;
    }

    // Template tiles.

    void add_master()
    {
        const MadePiece& made = made_piece(config_.axes, 0);
        scene_.columns = 2;
        ScenePanel thrown = tile_panel("Dart throwing fills a torus of one tile.");
        thrown.of(PointClass::inner) = made.filled.thrown;
        ScenePanel relaxed = tile_panel("Relaxation moves the points.");
        relaxed.of(PointClass::inner) = made.filled.active;
        scene_.panels = {thrown, relaxed};
    }

    void add_template()
    {
        const MadePiece& made = made_piece(config_.axes, 0);
        scene_.columns = 2;
        ScenePanel master = tile_panel("The master tile.");
        master.pieces = pieces_of_a_tile(0);
        for (const TilePosition& point : made.filled.active)
            master.of(cell_of(point).axes == all_axes(d_) ? PointClass::outer : PointClass::held)
                .push_back(point);
        ScenePanel frame = master;
        frame.caption = "The tile template: points farther from the border than the radius are discarded.";
        frame.of(PointClass::outer).clear();
        scene_.panels = {master, frame};
    }

    // Several pieces or tiles.

    void add_list()
    {
        for (const auto& [axes, variant] : wanted_pieces(config_))
            scene_.panels.push_back(axes == all_axes(d_) ? listed_tile(variant)
                                                         : listed_piece(axes, variant));
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
            panel.window.low[k] = (is_own ? extent.end : -extent.reach) - margin;
            panel.window.size[k] = (is_own ? tile_units - 2 * extent.end : 2 * extent.reach) + 2 * margin;
        }
        panel.part = panel.window;
        panel.pieces.push_back(piece_at(axes, {}, variant));
        panel.pieces.back().is_made = true;
        panel.of(PointClass::inner) = cut_out(made.filled.active, regions_, axes, made.base, false);
        return panel;
    }

    /// How far a region reaches across its cell, and how far from the cell's ends it begins.
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
            panel.of(cell_of(point).axes == all_axes(d_) ? PointClass::inner : PointClass::held)
                .push_back(point);
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
                // The tiles of a template have their own colours.
                if (p_.kind == PoissonTileKind::frame)
                    panel.pieces.push_back({all_axes(d_), {x, y, 0}, {tile}, false});
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
        for (std::size_t i = 0; i < points.size(); i += 2)
            panel.of(PointClass::held)
                .push_back({place[0] * tile_units + points[i], place[1] * tile_units + points[i + 1], 0});
    }

    const ConstructionConfig& config_;
    const MadeTiles& made_;
    const PoissonTileParameters& p_;
    int d_;
    TileRegions regions_;
    Scene scene_;
};

}

std::vector<PieceKey> wanted_pieces(const ConstructionConfig& config)
{
    if (config.show == "master" || config.show == "template") return {{config.axes, 0}};
    if (config.is_stage()) return {{config.axes, config.variant}};
    std::vector<PieceKey> keys;
    if (!config.is_list()) return keys;
    // Of many, some that are far from one another.
    const std::uint64_t all = piece_count(config.parameters, config.axes);
    for (std::uint64_t i = 0; i < config.count; ++i)
        keys.emplace_back(config.axes, static_cast<std::uint32_t>(i * all / config.count));
    return keys;
}

Scene make_scene(const ConstructionConfig& config, const MadeTiles& made)
{
    return ScenePanels(config, made).make();
}

}
