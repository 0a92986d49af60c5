#include "host/settings/method_needs.hpp"

#include "host/device/device.hpp"
#include "host/device/device_needs.hpp"

#include <utility>

namespace poissonlab {

KernelNeeds needs_in(const SamplerSpec& method, int dimension)
{
    KernelNeeds needs = needs_of(method.kernels);
    if (dimension == 3) needs |= needs_of(method.kernels_in_space);
    return needs;
}

KernelNeeds needs_of(const SamplerSpec& method, const Parameters& parameters, int dimension)
{
    KernelNeeds needs = needs_in(method, dimension);
    for (const auto& [key, entry] : parameters.given())
        if (const SamplerChoice* start = as_sampler(entry.value))
            needs |= needs_of(*start->spec, start->parameters, dimension);
    return needs;
}

SamplerSpec asking_for_needs(SamplerSpec method)
{
    if (method.kernels.empty()) return method;
    const KernelNeeds in_plane = needs_in(method, 2);
    const KernelNeeds in_space = needs_in(method, 3);
    method.create = [name = method.name, in_plane, in_space,
                     create = std::move(method.create)](const Parameters& parameters, const SampleRequest& request,
                                                        Engine engine, const DeviceProvider& device) {
        const bool is_plane = request.dimension == 2;
        const std::string what = is_plane || in_plane == in_space ? name : name + " in 3D";
        return create(parameters, request, engine, [what, needs = is_plane ? in_plane : in_space, device]() -> Device& {
            Device& opened = device();
            check_needs(what, needs, opened.info());
            return opened;
        });
    };
    return method;
}

}
