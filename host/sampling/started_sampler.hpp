// The base of samplers that begin with the sets of another method: their parameter `start`.
#pragma once

#include "host/sampling/device_sampler.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

/// The parameter `start`: random points by default.
ParameterSpec start_parameter();

/// The number of points that the start may have.
std::size_t most_started_points(const Parameters& parameters, const SampleRequest& request);

/// The memory that a method takes for sets of so many points.
using MemoryOfPoints = std::function<DeviceMemory(const Parameters&, std::size_t points, int dimension)>;

/// The parts of a description of such a method beside its name, parameters and create().
void describe_start(SamplerSpec& spec, const MemoryOfPoints& memory);

class StartedSampler : public DeviceSampler
{
public:
    SetTraits traits() const override { return {.sizes_vary = start_->traits().sizes_vary, .iterations = iterations_}; }

protected:
    /// `what` is in words what takes the memory, for example "Lloyd relaxation".
    StartedSampler(std::string what, MemoryOfPoints memory, const Parameters& parameters, const SampleRequest& request,
                   Engine engine, const DeviceProvider& device);

    /// The set to begin with. Throws InputError where the device has no room for it: starts from files and programs
    /// have as many points as they have.
    PointSet start(std::uint32_t realization);

    Parameters parameters_;
    std::vector<IterationRecord> iterations_; ///< of the last set

private:
    std::string what_;
    MemoryOfPoints memory_;
    std::unique_ptr<Sampler> start_;
};

}
