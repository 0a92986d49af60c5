// The Voronoi cells of points on the unit torus: what Lloyd relaxation needs of them.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// A value (displacements: `dimension` values) for each point. Points that coincide share their cell as if
/// shifted apart along x by an infinitesimal distance, in order of their numbers.
struct VoronoiCells
{
    int dimension = 2;
    std::vector<double> volumes;       ///< in 2D areas; they sum to 1
    std::vector<double> displacements; ///< from the point to the centroid of its cell
    std::vector<double> energies;      ///< integral over the cell of the squared distance to the point
    std::vector<double> squared_near;  ///< squared distance of the nearest point
};

namespace reference {
/// Finds Voronoi cells by CGAL's periodic Delaunay triangulations, whose decisions are exact. `points` has at least one
/// point.
VoronoiCells voronoi_cells(const PointSet& points);
}

/// Finds Voronoi cells by kernels/voronoi_2d.cl and voronoi_3d_*.cl.
class VoronoiKernels
{
public:
    /// Takes memory for sets of so many points.
    VoronoiKernels(Device device, int dimension, std::size_t points, std::size_t work_group_size);

    /// The memory that the results take.
    static DeviceMemory memory(int dimension, std::size_t points)
    {
        return memory_of(Buffers{}.needed(dimension, points));
    }

    /// The grid that points must be sorted by.
    static std::uint32_t cells_per_axis(int dimension, std::size_t points);

    /// Layers of a grid that must be held around those that are asked about, at least.
    static std::uint32_t least_around(int dimension) { return dimension == 2 ? 2 : 3; }

    /// Enqueues the computation for sorted points, those in cells of the grid that are asked about. Results are in
    /// sorted order.
    void find_cells(PointGrid& grid);

    /// False where points that the grid does not hold may cut one of the cells that were found last.
    bool are_known() const { return buffers_.unknown.read(0, 1)[0] == 0; }

    const Buffer<double>& volumes() const { return buffers_.volumes; }
    const Buffer<double>& displacements() const { return buffers_.displacements; }
    const Buffer<double>& energies() const { return buffers_.energies; }
    const Buffer<double>& squared_near() const { return buffers_.squared_near; }

    /// The number of points of the last call that needed the slow way; tests and benchmarks see by it that both ways
    /// run.
    std::size_t slow_points() const { return buffers_.slow_count.read(0, 1)[0]; }

private:
    struct Buffers
    {
        Buffer<double> volumes, displacements, energies, squared_near;
        Buffer<std::uint32_t> slow, slow_count, unknown;

        NeededBuffers needed(int dimension, std::size_t points);
    };

    int dimension_;
    std::uint32_t threads_; ///< of a processor; 0: another device
    std::size_t runs_a_group_, work_group_size_;
    Buffers buffers_;
    Kernel forget_slow_, find_fast_, find_slow_;
};

/// The memory that the following takes.
DeviceMemory voronoi_memory(int dimension, std::size_t points);

/// Everything at once, in the order of the points.
VoronoiCells voronoi_cells(Device device, const PointSet& points, std::size_t work_group_size = 64);

}
