#include "host/settings/method_needs.hpp"

#include "host/device/device.hpp"
#include "host/device/device_needs.hpp"

#include <utility>

namespace poissonlab {

KernelNeeds needs_of(const SamplerSpec& method, const Parameters& parameters)
{
    KernelNeeds needs = needs_of(method.kernels);
    for (const auto& [key, entry] : parameters.given())
        if (const SamplerChoice* start = as_sampler(entry.value)) needs |= needs_of(*start->spec, start->parameters);
    return needs;
}

SamplerSpec asking_for_needs(SamplerSpec method)
{
    if (method.kernels.empty()) return method;
    method.create = [name = method.name, needs = needs_of(method.kernels),
                     create = std::move(method.create)](const Parameters& parameters, const SampleRequest& request,
                                                        Engine engine, const DeviceProvider& device) {
        return create(parameters, request, engine, [name, needs, device]() -> Device& {
            Device& opened = device();
            check_needs(name, needs, opened.info());
            return opened;
        });
    };
    return method;
}

}
