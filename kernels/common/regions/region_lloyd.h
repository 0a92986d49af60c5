// The contract of region_lloyd.cl and its host code, host/sampling/regions/region_lloyd.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(region_lloyd)

enum
{
    MAX_LINES = 40 ///< of a cell; the host takes cells that have more while they are cut
};

/// Each listed cell of a grid has up to MAX_CLIPS edges, and NO_CLIP in the words that are left. In the square that has
/// the Voronoi cells of its sites, the region reaches at most CLIP_PART of the cell's width beyond the line of such an
/// edge. Voronoi cells are cut there: otherwise those at the boundary would reach far out of the region, among many
/// sites.
enum
{
    MAX_CLIPS = 4,
    NO_CLIP = 0x7fffffff
};
REAL(CLIP_PART, 0.5)

/// Square cells over the box of a region: 2^shift positions along each axis, from a lowest position on. They are numbered
/// with columns fastest: all of them or, in long regions, those that are listed, which something of the region is in.
struct SiteGrid
{
    double half_box; ///< what a site's cell has of the region lies in a square of twice this side around it
    uint low_x, low_y;
    uint columns, rows;
    uint shift;
    uint sites;
    uint is_listed;
    uint unused;
};

/// A cell's part of the region, relative to its site; lengths in positions.
struct CellMoments
{
    double twice_area;
    double x, y;    ///< six times the integrals of the coordinates
    uint is_known;  ///< 0: the cell has too many lines
    uint unused;
};

END_CONTRACT
