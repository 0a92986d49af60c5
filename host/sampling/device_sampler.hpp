// The base of samplers that may work on a device.
#pragma once

#include "host/device/device.hpp"
#include "host/sampling/sampler.hpp"

namespace poissonlab {

class DeviceSampler : public Sampler
{
public:
    /// Seconds of compiling kernels since it was made; a sampler that it starts from uses the same device, and counts.
    double build_seconds() const final { return device_ ? device_->build_seconds() - built_before_ : 0; }

protected:
    /// Opens the device where it is the engine.
    DeviceSampler(Engine engine, const DeviceProvider& device)
        : device_(engine == Engine::opencl ? &device() : nullptr), built_before_(device_ ? device_->build_seconds() : 0)
    {}

    Device* const device_; ///< null: the reference does the work

private:
    double built_before_; ///< by earlier users of the device
};

}
