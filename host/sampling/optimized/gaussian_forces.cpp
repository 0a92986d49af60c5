#include "host/sampling/optimized/gaussian_forces.hpp"

#include <cmath>

namespace poissonlab {

using contract::gaussian_blue_noise::BLOCK_POINTS;

NeededBuffers GaussianForces::Buffers::needed(int dimension, std::size_t points, const GaussianFieldShape* shape)
{
    NeededBuffers all{
        {displacements, points * static_cast<std::size_t>(dimension)}, {energies, points}, {squared_near, points}};
    if (shape != nullptr) all.push_back({cells, shape->cells()});
    return all;
}

GaussianForces::GaussianForces(Device device, int dimension, std::size_t most_points, const GaussianRequest& request,
                               std::size_t points, std::size_t work_group_size)
    : work_group_size_(work_group_size), field_(request.field), gaussians_(gaussians_for(request, points, dimension)),
      sum_(device.kernel(
          kernel_program("gaussian_blue_noise.cl",
                         {{"DIMENSION", dimension}, {"ADAPTIVE", field_ ? 1 : 0}, {"LISTED", is_listed() ? 1 : 0}}),
          "sum_gaussians"))
{
    reserve(device, buffers_.needed(dimension, most_points, field_ ? &field_->shape : nullptr));
    if (field_) buffers_.cells.write(field_->cells);
}

std::uint32_t GaussianForces::layers_around(const GaussianRequest& request, std::size_t points, int dimension)
{
    // The kernel's own reach is longer by less than a thousandth of a cell, and places are rounded.
    const double side = std::pow(static_cast<double>(points), 1.0 / dimension);
    const double reach = gaussian_cut_off * request.sigma / side * gaussian_grid_size(request, points, dimension);
    return static_cast<std::uint32_t>(reach * 1.001) + 2;
}

void GaussianForces::find(PointGrid& grid)
{
    const auto [first, end] = grid.own_points();
    gaussians_.first = static_cast<std::uint32_t>(first);
    gaussians_.end = static_cast<std::uint32_t>(end);
    gaussians_.stride = grid.stride();
    const std::size_t blocks = (end - first + BLOCK_POINTS - 1) / BLOCK_POINTS;
    if (is_listed())
        sum_.run(blocks, work_group_size_, gaussians_, grid.part(), grid.positions(), grid.fixed_point(), grid.starts(),
                 buffers_.displacements, buffers_.energies, buffers_.squared_near, buffers_.cells, field_->shape.size,
                 grid.row_starts(), grid.columns());
    else if (field_)
        sum_.run(blocks, work_group_size_, gaussians_, grid.part(), grid.positions(), grid.fixed_point(), grid.starts(),
                 buffers_.displacements, buffers_.energies, buffers_.squared_near, buffers_.cells, field_->shape.size);
    else
        sum_.run(blocks, work_group_size_, gaussians_, grid.part(), grid.positions(), grid.fixed_point(), grid.starts(),
                 buffers_.displacements, buffers_.energies, buffers_.squared_near);
}

}
