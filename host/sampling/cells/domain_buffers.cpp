#include "host/sampling/cells/domain_buffers.hpp"

#include <vector>

namespace poissonlab {
namespace {

/// A buffer of the values, or of one element if there are none: a kernel's argument needs a buffer.
template <typename T>
Buffer<T> upload(Device& device, std::vector<T> values)
{
    if (values.empty()) values.push_back(0);
    Buffer<T> buffer = device.buffer<T>(values.size());
    buffer.write(values);
    return buffer;
}

}

DomainBuffers::DomainBuffers(Device device, const Domain& domain, int dimension)
    : region_count(static_cast<std::uint32_t>(domain.forbidden.size())), has_fixed(!domain.is_fixed.empty())
{
    std::vector<double> region_values;
    std::vector<double> half_space_values;
    std::size_t first = 0;
    for (const ConvexRegion& region : domain.forbidden) {
        const std::size_t end = first + region.half_spaces.size();
        for (int k = 0; k < dimension; ++k) region_values.push_back(region.centre[k]);
        region_values.push_back(static_cast<double>(first));
        region_values.push_back(static_cast<double>(end));
        for (const HalfSpace& half_space : region.half_spaces) {
            for (int k = 0; k < dimension; ++k) half_space_values.push_back(half_space.normal[k]);
            half_space_values.push_back(half_space.offset);
        }
        first = end;
    }
    regions = upload(device, std::move(region_values));
    half_spaces = upload(device, std::move(half_space_values));
    is_fixed = upload(device, domain.is_fixed);
}

DeviceMemory DomainBuffers::memory_of_torus()
{
    return DeviceMemory{}.add(sizeof(double)).add(sizeof(double)).add(sizeof(std::uint8_t));
}

PointMover::PointMover(Device device, const Domain& domain, int dimension, std::size_t work_group_size)
    : work_group_size_(work_group_size), domain_(device, domain, dimension)
{
    const KernelValue doubles = domain.forbidden.empty() ? doubles_of(device) : KernelValue("DOUBLES", 1);
    move_ = device.kernel(kernel_program("relaxation.cl", {{"DIMENSION", dimension}, doubles}), "move_points");
}

void PointMover::move(PointGrid& grid, const Buffer<double>& displacements, bool slides)
{
    move_.run(grid.size(), work_group_size_, grid.positions(), grid.ids(), displacements,
              static_cast<std::uint32_t>(grid.size()), domain_.is_fixed, domain_.has_fixed, domain_.regions,
              domain_.region_count, domain_.half_spaces, std::uint32_t{slides});
}

}
