// Domains on a device, and the movement of points in them. Runs move_points of kernels/relaxation.cl.
#pragma once

#include "host/device/device.hpp"
#include "host/sampling/cells/domain.hpp"
#include "host/sampling/cells/point_grid.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// A domain as kernels/common/domain.clh wants it. Empty lists have a buffer of one element.
struct DomainBuffers
{
    DomainBuffers(Device device, const Domain& domain, int dimension);

    /// The memory that the whole torus takes if no points are held: almost none.
    static DeviceMemory memory_of_torus();

    Buffer<double> regions;     ///< dimension + 2 values each: centre, first and end of its half-spaces
    Buffer<double> half_spaces; ///< dimension + 1 values each: normal, offset
    Buffer<std::uint8_t> is_fixed;
    std::uint32_t region_count;
    std::uint32_t has_fixed; ///< 0: is_fixed holds nothing
};

/// Moves points by what a domain allows, see allowed_displacement().
class PointMover
{
public:
    /// `domain.is_fixed` is empty or has a value for each point that will be moved. `work_group_size` > 0.
    PointMover(Device device, const Domain& domain, int dimension, std::size_t work_group_size);

    /// Enqueues the movement. Displacements are in sorted order, dimension values each, components in [-1,
    /// 1]; the points are no longer sorted after it.
    void move(PointGrid& grid, const Buffer<double>& displacements, bool slides);

    const DomainBuffers& domain() const { return domain_; }

private:
    std::size_t work_group_size_;
    DomainBuffers domain_;
    Kernel move_;
};

}
