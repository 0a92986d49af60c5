// The questions that the config can ask of methods that follow the law of dart throwing, and what it is told when that
// is impossible.
#pragma once

#include "host/sampling/dart_throwing.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

/// Makes the set that is asked for, or as much of it as there is room for.
using ThrowDarts = std::function<PointSet(const DartThrowingRequest&)>;

/// One way to throw darts.
struct DartMethod
{
    std::string name, title, summary; ///< see SamplerSpec
    std::vector<int> dimensions;
    Purpose purpose{};
    std::vector<std::string> kernels; ///< see SamplerSpec
    std::function<DeviceMemory(const DartThrowingRequest&, const DeviceInfo&)> memory;
    std::function<ThrowDarts(Device*)> thrower; ///< on a device; the reference where there is none
};

/// The thrower of a DartMethod from its two engines.
template <typename Thrower, auto throw_reference_darts>
ThrowDarts thrower_by(Device* device)
{
    if (!device) return throw_reference_darts;
    return [thrower = std::make_shared<Thrower>(*device)](const DartThrowingRequest& request) {
        return thrower->throw_darts(request);
    };
}

/// Makes the sampler of a method: relative_radius, or stop = "saturation" with min_distance.
SamplerSpec dart_sampler(const DartMethod& method);

}
