// The description of a method that has nothing to check beyond the range of each parameter.
#pragma once

#include "host/sampling/sampler.hpp"

#include <utility>

namespace poissonlab {

/// Methods set what else they need, and a check of their own where combinations can be wrong.
inline SamplerSpec plain_spec(std::string name, std::string title, std::string summary, std::vector<int> dimensions,
                              std::vector<ParameterSpec> parameters = {})
{
    SamplerSpec spec;
    spec.name = std::move(name);
    spec.title = std::move(title);
    spec.summary = std::move(summary);
    spec.dimensions = std::move(dimensions);
    spec.parameters = std::move(parameters);
    spec.check = [](const Parameters&, const SampleRequest&, const SourceLocation&) {};
    return spec;
}

}
