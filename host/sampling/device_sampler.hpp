// What samplers that work on an OpenCL device have in common.
#pragma once

#include "host/device/device.hpp"
#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// Opens the device where the engine is OpenCL, and knows how long its kernels took to build.
class DeviceSampler : public Sampler
{
public:
    double build_seconds() const override { return device_ ? device_->build_seconds() - built_before_ : 0; }

protected:
    DeviceSampler(Engine engine, const DeviceProvider& device)
        : device_(engine == Engine::opencl ? &device() : nullptr), built_before_(device_ ? device_->build_seconds() : 0)
    {}

    Device* const device_; ///< null: the reference does the work

private:
    double built_before_; ///< by earlier users of the device
};

}
