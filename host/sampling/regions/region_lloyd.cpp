// Runs kernels/region_lloyd.cl, and moves sites to centroids.
#include "host/sampling/regions/region_lloyd.hpp"

#include "base/programs/interrupt.hpp"
#include "host/device/needed_buffers.hpp"

#include <cmath>

namespace poissonlab {
namespace {

using contract::region_lloyd::CellMoments;

/// Halves of a way to a centroid that is not allowed.
constexpr int most_halves = 8;

/// The site after a step; the cell's moments are relative to it.
TorusPoint<2> moved(const FixedRegion& region, const TorusPoint<2>& site, const CellMoments& moments)
{
    if (!(moments.twice_area > 0)) return site;
    double x = moments.x / (3 * moments.twice_area), y = moments.y / (3 * moments.twice_area);
    for (int i = 0; i < most_halves; ++i, x /= 2, y /= 2) {
        const double at_x = site[0] + std::floor(x + 0.5), at_y = site[1] + std::floor(y + 0.5);
        if (!(at_x >= 0 && at_y >= 0 && at_x < 0x1p31 && at_y < 0x1p31)) continue;
        const TorusPoint<2> to{static_cast<std::uint32_t>(at_x), static_cast<std::uint32_t>(at_y)};
        if (region.contains(to)) return to;
    }
    return site;
}

template <class T>
std::span<const std::uint32_t> words_of(std::span<const T> values)
{
    return {reinterpret_cast<const std::uint32_t*>(values.data()), values.size_bytes() / sizeof(std::uint32_t)};
}

}

std::vector<TorusPoint<2>> relax_in_region(const FixedRegion& region, const FixedRegion& land,
                                           std::vector<TorusPoint<2>> sites, std::size_t iterations,
                                           const CellIntegrals& integrals, bool is_listed)
{
    SiteGrid grid(land, sites.size(), is_listed);
    for (std::size_t iteration = 0; iteration < iterations; ++iteration) {
        stop_if_interrupted();
        grid.sort(sites);
        const std::vector<CellMoments> moments = integrals(grid);
        for (std::size_t i = 0; i < sites.size(); ++i)
            sites[grid.numbers()[i]] = moved(region, grid.sites()[i], moments[i]);
    }
    return sites;
}

struct RegionLloydBuffers
{
    Buffer<std::uint32_t> sites, starts, edges, edge_starts, edge_numbers, row_starts, listed_columns, clips;
    Buffer<std::uint8_t> is_inside;
    Buffer<CellMoments> moments;

    NeededBuffers needed(const SiteGrid& grid)
    {
        const std::size_t count = grid.grid().sites;
        const std::size_t starts_of_cells = grid.edge_starts().size();
        return {{sites, 2 * count},
                {starts, starts_of_cells},
                {edges, 4 * grid.edges().size()},
                {edge_starts, starts_of_cells},
                {edge_numbers, grid.edge_numbers().size()},
                {row_starts, grid.row_starts().size()},
                {listed_columns, grid.listed_columns().size()},
                {clips, grid.clip_words()},
                {is_inside, count},
                {moments, count}};
    }
};

RegionLloyd::RegionLloyd(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<RegionLloydBuffers>())
{}

std::vector<CellMoments> RegionLloyd::integrate_cells(const SiteGrid& grid)
{
    RegionLloydBuffers& b = *buffers_;
    reserve(device_, b.needed(grid));
    b.sites.write(words_of(grid.sites()));
    b.starts.write(grid.starts());
    b.is_inside.write(grid.is_inside());
    b.edges.write(words_of(grid.edges()));
    b.edge_starts.write(grid.edge_starts());
    b.edge_numbers.write(grid.edge_numbers());
    b.row_starts.write(grid.row_starts());
    b.listed_columns.write(grid.listed_columns());
    b.clips.write(grid.clips());
    Kernel integrate = device_.kernel(kernel_program("region_lloyd.cl", {}), "integrate_cells");
    integrate.run(grid.sites().size(), work_group_size_, grid.grid(), b.sites, b.starts, b.is_inside, b.edges,
                  b.edge_starts, b.edge_numbers, b.row_starts, b.listed_columns, b.clips, b.moments);
    std::vector<CellMoments> moments = b.moments.read(0, grid.sites().size());
    for (std::size_t i = 0; i < moments.size(); ++i)
        if (moments[i].is_known == 0) moments[i] = reference::integrate_cell(grid, i);
    return moments;
}

DeviceMemory RegionLloyd::memory(const SiteGrid& grid) { return memory_of(RegionLloydBuffers{}.needed(grid)); }

}
