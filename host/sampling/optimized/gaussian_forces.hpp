// The forces of Gaussian blue noise on a device. Runs kernels/gaussian_blue_noise.cl.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <cstddef>
#include <memory>

namespace poissonlab {

class GaussianForces
{
public:
    /// Takes memory for so many points at a time, of sets of `points`. `work_group_size` > 0.
    GaussianForces(Device device, int dimension, std::size_t most_points, const GaussianRequest& request,
                   std::size_t points, std::size_t work_group_size);

    /// The memory that the results take, and the field of this shape, if there is one.
    static DeviceMemory memory(int dimension, std::size_t points, const GaussianFieldShape* shape)
    {
        return memory_of(Buffers{}.needed(dimension, points, shape));
    }

    /// Layers of a grid of this size that must be held around those that are asked about; without a density.
    static std::uint32_t layers_around(const GaussianRequest& request, std::size_t points, int dimension);

    /// Enqueues the computation for sorted points, those in cells of the grid that are asked about. Results are in
    /// sorted order.
    void find(PointGrid& grid);

    const Buffer<double>& displacements() const { return buffers_.displacements; }
    const Buffer<double>& energies() const { return buffers_.energies; }
    const Buffer<double>& squared_near() const { return buffers_.squared_near; }

private:
    struct Buffers
    {
        Buffer<double> displacements, energies, squared_near;
        Buffer<contract::gaussian_blue_noise::DensityCell> cells;

        NeededBuffers needed(int dimension, std::size_t points, const GaussianFieldShape* shape);
    };

    bool is_listed() const { return field_ && field_->shape.listed > 0; }

    std::size_t work_group_size_;
    std::shared_ptr<const GaussianField> field_;
    contract::gaussian_blue_noise::Gaussians gaussians_;
    Buffers buffers_;
    Kernel sum_;
};

}
