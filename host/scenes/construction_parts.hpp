// The parts of all panels of a picture of a construction: pieces, points, and boxes around them.
#pragma once

#include "host/scenes/construction_panels.hpp"

#include <span>
#include <string>
#include <vector>

namespace poissonlab {

inline constexpr std::int32_t panel_margin = tile_units / 20; ///< around what a panel shows

/// A box around the whole region of a cell at the origin, or of a tile, with what lies at its ends.
SceneBox box_around(const TileRegions& regions, std::uint8_t axes, std::int32_t reach);

class PanelParts
{
public:
    PanelParts(const ShownConstruction& config, const MadeTiles& made);

protected:
    ScenePanel new_panel() const;

    /// A tile with its border.
    ScenePanel tile_panel(const std::string& caption) const;

    ScenePiece piece_at(std::uint8_t axes, const std::array<std::int32_t, 3>& base, std::uint32_t variant) const;

    /// The pieces around a tile at the origin.
    std::vector<ScenePiece> pieces_of_a_tile(std::uint32_t tile) const;

    const MadePiece& made_piece(std::uint8_t axes, std::uint32_t variant) const;

    /// Points of a torus relative to a cell of it, those that the window shows.
    std::vector<TilePosition> shown(std::span<const TilePosition> points, const std::array<std::int8_t, 3>& base,
                                    const SceneBox& window) const;

    /// The cell whose region a position is in, of the unbounded lattice.
    ScenePiece cell_of(const TilePosition& position) const;

    const ShownConstruction& config_;
    const MadeTiles& made_;
    const PoissonTileParameters& p_;
    int d_;
    TileRegions regions_;
    Scene scene_;
};

/// The pictures by what they show.
Scene region_scene(const ShownConstruction& config, const MadeTiles& made);
Scene stage_scene(const ShownConstruction& config, const MadeTiles& made);

}
