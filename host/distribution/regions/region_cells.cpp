#include "host/distribution/regions/region_cells.hpp"

#include "base/errors/errors.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/regions/region_bricks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poissonlab {
namespace {

/// A distance has so many positions at least: in sets on a coarser grid one would see it.
constexpr double least_positions_of_distance = 256;

/// Cells of bricks at most: as many as a cube has.
constexpr double most_brick_cells = max_level_0_cells / 4;

/// A cube is taken where it has at most so many cells, or is filled to so large a part.
constexpr double few_cells_of_cube = 1 << 14;
constexpr double well_filled_cube = 1.0 / 4;

/// Cells of the cube that has half of the torus along each axis.
double cells_of_cube(double min_distance, int dimension)
{
    return level_0_cells(min_distance, dimension) / (dimension == 2 ? 4 : 8);
}

double most_cells_of_cube(int dimension) { return dimension == 2 ? most_brick_cells : max_level_0_cells; }

/// The cells of level 0 in which regions lie, a quarter of the torus or an eighth, where these are fewer than all.
std::optional<DartBlock> block_of_regions(const CellHierarchy& cells)
{
    const std::uint32_t size = cells.cell_of((1u << FixedRegion::coordinate_bits) - 1) + 1;
    if (size + static_cast<std::uint32_t>(cells.reach) > cells.size) return {};
    return DartBlock{{}, size};
}

void check_positions(double min_distance, double side)
{
    const double least = least_positions_of_distance * 0x1p-32;
    if (min_distance >= least) return;
    throw InputError(fmt::format("a minimum distance of {:.3g} is too short for a region of this extent, along which "
                                 "2^31 positions are told apart; at least {:.3g}",
                                 min_distance * side, least * side));
}

/// The part of the cube that is the region.
double filled_part_of_cube(const DartThrowingRequest& request)
{
    if (request.region) return request.region->area() / std::pow(request.region->unit() * 0x1p31, 2);
    return request.space->volume() / std::pow(request.space->unit() * 0x1p31, 3);
}

std::shared_ptr<const DartBricks> bricks_for(const DartThrowingRequest& request, const CellHierarchy& cells,
                                             double most)
{
    const auto bricks = static_cast<std::size_t>(most) / contract::dart_throwing::BRICK_CELLS;
    return request.region ? bricks_of(*request.region, cells, bricks) : bricks_of(*request.space, cells, bricks);
}

}

bool is_long(double min_distance, int dimension)
{
    return cells_of_cube(min_distance, dimension) > most_cells_of_cube(dimension);
}

CandidateArea candidate_area(double min_distance, int dimension)
{
    return is_long(min_distance, dimension) ? CandidateArea::squares : CandidateArea::box;
}

void choose_cells(DartThrowingRequest& request, double side)
{
    check_positions(request.min_distance, side);
    const CellHierarchy cells = cell_hierarchy(request.min_distance, request.dimension);
    const double in_cube = cells_of_cube(request.min_distance, request.dimension);
    const bool is_too_long = is_long(request.min_distance, request.dimension);
    if (!is_too_long) request.block = block_of_regions(cells);
    if (in_cube <= few_cells_of_cube || (!is_too_long && filled_part_of_cube(request) > well_filled_cube)) return;
    request.bricks = bricks_for(request, cells, is_too_long ? most_brick_cells : in_cube * well_filled_cube);
    if (request.bricks || !is_too_long) return;
    const double more = std::max(1.0, filled_part_of_cube(request) * in_cube / most_brick_cells);
    throw InputError(fmt::format("a minimum distance of {:.3g} leaves room for more points in the region than there is "
                                 "memory for; at least some {:.2g} (in metres, where the region is in "
                                 "longitude and latitude)",
                                 request.min_distance * side,
                                 1.5 * request.min_distance * side * std::pow(more, 1.0 / request.dimension)));
}

}
