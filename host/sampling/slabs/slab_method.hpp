// Methods that move points, as steps that can be made slab by slab.
#pragma once

#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace poissonlab {

/// The step of a method: displacements of sorted points in the cells of a grid that are asked about.
class SlabMethod
{
public:
    virtual ~SlabMethod() = default;

    /// The cells of its grid along each axis of the torus.
    virtual std::uint32_t cells_per_axis() const = 0;

    /// Layers of cells around a slab that it looks at, at least.
    virtual std::uint32_t layers_around() const = 0;

    /// The device memory that it takes for so many points at a time, beside the grid's.
    virtual DeviceMemory memory(std::size_t points) const = 0;

    /// Takes memory for so many points.
    virtual void make_room(Device& device, std::size_t points) = 0;

    virtual void find(PointGrid& grid) = 0;

    /// False where what was found last depends on points that the grid does not hold.
    virtual bool is_known() const { return true; }

    // These return what was found, in sorted order: dimension values a point, and squared distances of nearest points.
    virtual const Buffer<double>& displacements() const = 0;
    virtual const Buffer<double>& squared_near() const = 0;
};

/// Lloyd relaxation of a set of so many points.
std::unique_ptr<SlabMethod> lloyd_in_slabs(int dimension, std::size_t points);

/// Gaussian blue noise of a set of so many points, without a density.
std::unique_ptr<SlabMethod> gaussians_in_slabs(const GaussianRequest& request, int dimension, std::size_t points);

}
