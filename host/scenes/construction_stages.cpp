// Panels of the stages of a piece, a tile, or a template: figures 4.5 to 4.24 and 4.34 to 4.37.
#include "host/scenes/construction_parts.hpp"

#include "host/tile_construction/boundary_stages.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

class StageScene : PanelParts
{
public:
    using PanelParts::PanelParts;

    Scene make()
    {
        if (config_.show == "master")
            add_master();
        else if (config_.show == "template")
            add_template();
        else if (config_.axes == all_axes(d_))
            add_tile_stages();
        else
            add_piece_stages();
        return std::move(scene_);
    }

private:
    // Views of a piece.

    /// The whole torus in 2D. In 3D the piece and the pieces at its ends: more would hide them.
    SceneBox stage_window() const
    {
        if (d_ == 3) return box_around(regions_, config_.axes, regions_.corner_one + panel_margin);
        SceneBox box;
        for (int k = 0; k < d_; ++k) {
            box.low[k] = (config_.axes >> k & 1 ? tile_units / 2 : 0) - tile_units;
            box.size[k] = torus_units;
        }
        return box;
    }

    /// Pieces of a torus relative to a cell of it, wherever the window shows them.
    std::vector<ScenePiece> shown_pieces(std::span<const PlacedPiece> pieces, const std::array<std::int8_t, 3>& base,
                                         const SceneBox& window) const
    {
        std::vector<ScenePiece> result;
        for (const PlacedPiece& piece : pieces)
            for (int turn = 0; turn < (d_ == 2 ? 9 : 27); ++turn) {
                const std::array<std::int32_t, 3> turns{turn % 3 - 1, turn / 3 % 3 - 1, d_ == 2 ? 0 : turn / 9 - 1};
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
        assembled.of(PointClass::held) = near(shown(made.problem.held, made.base, empty.window), assembled.pieces);
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

    /// The points in the regions of some pieces.
    std::vector<TilePosition> near(std::vector<TilePosition> points, const std::vector<ScenePiece>& pieces) const
    {
        std::erase_if(points, [&](const TilePosition& point) {
            const ScenePiece cell = cell_of(point);
            return std::ranges::none_of(
                pieces, [&](const ScenePiece& piece) { return piece.axes == cell.axes && piece.base == cell.base; });
        });
        return points;
    }

    /// Points of a torus that are not held, by whether they are in the piece that is made.
    void add_free(ScenePanel& panel, std::span<const TilePosition> points, const std::array<std::int8_t, 3>& base) const
    {
        for (const TilePosition& point : shown(points, base, panel.window)) {
            const ScenePiece cell = cell_of(point);
            const bool is_inner = cell.axes == config_.axes && cell.base == std::array<std::int32_t, 3>{};
            panel.of(is_inner ? PointClass::inner : PointClass::outer).push_back(point);
        }
    }

    // Views of a tile.

    /// The distance around a tile up to which there are points while its interior is made.
    std::int32_t surroundings_margin() const
    {
        return std::max(regions_.pair_one, std::min(tile_units / 2 - panel_margin, 3 * regions_.width));
    }

    void add_tile_stages()
    {
        const MadePiece& made = made_piece(config_.axes, config_.variant);
        ScenePanel empty = tile_panel("");
        if (p_.kind != PoissonTileKind::frame) {
            empty.window = d_ == 3 ? box_around(regions_, config_.axes, regions_.corner_one + panel_margin)
                                   : box_around(regions_, config_.axes, surroundings_margin() + panel_margin);
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
        thrown.of(PointClass::surroundings) = shown(made.filled.thrown_surroundings, {}, thrown.part);
        if (d_ == 3)
            thrown.caption = "Dart throwing fills the exterior, so that relaxation does not draw points there.";
        else if (!thrown.of(PointClass::surroundings).empty())
            thrown.caption = "Dart throwing fills the interior, and what is around the tile, so that relaxation does "
                             "not draw points there.";
        scene_.panels.push_back(thrown);

        ScenePanel relaxed = thrown;
        relaxed.of(PointClass::inner) = shown(made.filled.active, {}, relaxed.part);
        relaxed.of(PointClass::surroundings) = shown(made.filled.surroundings, {}, relaxed.part);
        relaxed.caption = d_ == 3 ? "Relaxation moves the points of the interior."
                                  : "Relaxation moves the points of the interior and those around the tile.";
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

    // Views of template tiles.

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
            master.of(cell_of(point).axes == all_axes(d_) ? PointClass::outer : PointClass::held).push_back(point);
        ScenePanel frame = master;
        frame.caption = "The tile template: points farther from the border than the radius are discarded.";
        frame.of(PointClass::outer).clear();
        scene_.panels = {master, frame};
    }
};

}

Scene stage_scene(const ShownConstruction& config, const MadeTiles& made) { return StageScene(config, made).make(); }

}
