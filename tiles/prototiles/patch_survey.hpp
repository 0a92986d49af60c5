// The relations between tiles of a patch: how they meet along edges and around corners. All of it follows
// from exact places, and so shows whether tiles fill the plane without gaps and overlaps.
#pragma once

#include "tiles/prototiles/polygon_tiling.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// The tiles around a corner, and how many corners have them.
struct VertexFigure
{
    std::string tiles; ///< "kite 72 Aa, ...", or the numbers of sides where all are regular polygons: "3.12.12"
    std::size_t count = 0;
};

struct PatchSurvey
{
    std::size_t inner_edges =
        0; ///< with a tile on each side; pieces between corners, as tiles need not meet edge to edge
    std::size_t border_edges = 0;  ///< with a tile on one side
    std::vector<RingPlace> border; ///< where border edges start, in no particular order
    std::size_t crowded_edges = 0; ///< with more than one tile on a side: tiles overlap
    std::size_t unfit_edges = 0;   ///< inner edges whose letters do not fit
    std::size_t labelled_edges = 0;
    std::size_t inner_vertices = 0;    ///< with tiles all around
    std::size_t odd_vertices = 0;      ///< whose angles do not add up to one turn: tiles overlap
    bool is_edge_to_edge = true;       ///< no corner lies within an edge
    std::vector<VertexFigure> figures; ///< of inner vertices, most frequent ones first
};

/// All tiles have one scale.
PatchSurvey survey_patch(const PolygonTiling& tiling, std::span<const PlacedTile> tiles);

}
