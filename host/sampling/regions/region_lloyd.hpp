// Lloyd's method in a region of the plane: each point moves to the centroid of what its Voronoi cell has of the region.
//
// Du, Faber, Gunzburger, Centroidal Voronoi tessellations, SIAM Review 41(4), 1999. Cells are those of plain distances,
// also around corners and across holes. Where a centroid is not allowed (outside of a region that is not convex, or too
// near to an obstacle) the point goes half of the way, or a quarter, ...: the mean squared distance of the cell from
// its point falls all along the way. Positions are rounded to those of the region's grid after each step.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/regions/site_grid.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace poissonlab {

/// Moments of the cells of sites that a grid has sorted.
using CellIntegrals = std::function<std::vector<contract::region_lloyd::CellMoments>(const SiteGrid&)>;

/// The sites after so many steps, in their order. All have to be allowed, and stay in `region`; cells are cut at the
/// boundary of `land`, which has the same grid and what is allowed inside. `is_listed` is what a SiteGrid takes.
std::vector<TorusPoint<2>> relax_in_region(const FixedRegion& region, const FixedRegion& land,
                                           std::vector<TorusPoint<2>> sites, std::size_t iterations,
                                           const CellIntegrals& integrals, bool is_listed = false);

namespace reference {
/// Integrates one cell after the other.
std::vector<contract::region_lloyd::CellMoments> integrate_cells(const SiteGrid& grid);

contract::region_lloyd::CellMoments integrate_cell(const SiteGrid& grid, std::size_t site);
}

/// Integrates cells by kernels/region_lloyd.cl: every device finds the bytes of the reference.
class RegionLloyd : DeviceMethod<struct RegionLloydBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit RegionLloyd(Device device, std::size_t work_group_size = 0);

    std::vector<contract::region_lloyd::CellMoments> integrate_cells(const SiteGrid& grid);

    /// The memory that this takes.
    static DeviceMemory memory(const SiteGrid& grid);
};

}
