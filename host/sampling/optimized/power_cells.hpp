// The cells of power diagrams of points on the unit torus, in 2D: what equal areas need of them.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/needed_buffers.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace poissonlab {

/// Values for each point, in the order of the set.
struct PowerCells
{
    std::vector<double> areas;         ///< 0: other cells take all of it
    std::vector<double> displacements; ///< two each: from the point to the centroid of its cell
    std::vector<double> energies;      ///< integral over the cell of the squared distance to the point
    /// MAX_NEIGHBORS each, or fewer and then UINT32_MAX: the numbers of points with an edge in common, and how much
    /// area one of the two gives the other for a unit of weight.
    std::vector<std::uint32_t> neighbours;
    std::vector<double> exchanges;
};

/// The cells of a grid along each axis.
std::uint32_t power_grid(std::size_t points);

namespace reference {
PowerCells power_cells(const PointSet& points, const std::vector<double>& weights);
}

/// Finds power cells by kernels/power_cells.cl: every device finds the bytes of the reference.
class PowerDiagram
{
public:
    /// Takes memory for sets of so many points. `work_group_size` 0: the default.
    PowerDiagram(Device device, std::size_t points, std::size_t work_group_size = 0);

    PowerCells cells(const PointSet& points, const std::vector<double>& weights);

    static DeviceMemory memory(std::size_t points);

private:
    std::shared_ptr<struct PowerDiagramState> state_;
};

}
