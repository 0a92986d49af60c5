// Panels of regions alone: figures 4.3, 4.30, 4.31 and 4.33.
#include "host/scenes/construction_parts.hpp"

#include "tiles/poisson/tile_pieces.hpp"

#include <bit>

namespace poissonlab {
namespace {

class RegionScene : PanelParts
{
public:
    using PanelParts::PanelParts;

    Scene make()
    {
        if (config_.show == "kinds")
            add_kinds();
        else
            d_ == 2 ? add_plane_regions() : add_space_regions();
        return std::move(scene_);
    }

private:
    /// Adds both kinds of regions side by side: each in a scene of its own would be drawn to another scale.
    void add_plane_regions()
    {
        scene_.columns = 2;
        for (const bool modified : {false, true}) {
            ScenePanel panel = tile_panel(modified ? "The modified regions: corner regions are enlarged such that edge "
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
        const std::array<const char*, 4> names{"The corner regions.", "The edge regions.", "The face regions.",
                                               "The interior region."};
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
        // This tile lacks the pieces at the corner nearest to the viewer, who is in the south-east and above.
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
        const std::array<const char*, 4> names{"Corner tiles: great rhombicuboctahedra.", "Edge tiles.", "Face tiles.",
                                               "Interior tiles."};
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
};

}

Scene region_scene(const ShownConstruction& config, const MadeTiles& made) { return RegionScene(config, made).make(); }

}
