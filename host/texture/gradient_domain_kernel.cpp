// Harmonic functions by the kernel, kernels/gradient_domain.cl.
#include "host/device/device.hpp"
#include "host/device/kernel_program.hpp"
#include "host/texture/gradient_domain.hpp"
#include "kernels/common/fields/gradient_domain.h"

namespace poissonlab {

void relax_on(Device& device, GradientDomain& domain, std::size_t work_group_size)
{
    const std::size_t pixels = static_cast<std::size_t>(domain.size) * static_cast<std::size_t>(domain.size);
    Buffer<std::uint8_t> inside = device.buffer<std::uint8_t>(domain.inside.size());
    Buffer<double> values = device.buffer<double>(domain.values.size());
    inside.write(domain.inside);
    values.write(domain.values);
    const contract::gradient_domain::GradientDomainSizes sizes{domain.size, domain.channels, domain.sweeps(),
                                                               domain.relaxation()};
    Kernel kernel = device.kernel(kernel_program("gradient_domain.cl", {}), "relax_gradient_domain");
    kernel.run(domain.values.size() / pixels * work_group_size, work_group_size, sizes, inside, values);
    values.read(domain.values);
}

}
