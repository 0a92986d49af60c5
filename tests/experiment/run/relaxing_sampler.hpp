// A registry with a sampler that starts from another one, as iterative methods do, made for the tests.
#pragma once

#include "host/sampling/sampler.hpp"
#include "host/settings/sampler_registry.hpp"

namespace poissonlab {

/// The registry's samplers and "relax": iterations, start, keep, repulsion. Its sets are those of its start;
/// it refuses to start from nothing.
inline const SamplerRegistry& registry_with_relax()
{
    static const SamplerRegistry registry = [] {
        using Kind = ParameterSpec::Kind;
        ParameterSpec iterations;
        iterations.key = "iterations";
        iterations.kind = Kind::integer;
        iterations.maximum = 1e18;
        iterations.symbol = "i";
        ParameterSpec start;
        start.key = "start";
        start.kind = Kind::sampler;
        ParameterSpec keep;
        keep.key = "keep";
        keep.kind = Kind::choice;
        keep.choices = {"last", "best"};
        ParameterSpec repulsion;
        repulsion.key = "repulsion";
        repulsion.kind = Kind::boolean;

        SamplerSpec relax;
        relax.name = "relax";
        relax.title = "Relaxation";
        relax.dimensions = {2};
        relax.parameters = {iterations, start, keep, repulsion};
        relax.follows_start = true;
        relax.check = [](const Parameters& parameters, const SampleRequest&, const SourceLocation& where) {
            if (!parameters.is_given("start")) throw InputError(to_string(where) + ": start is missing");
        };
        relax.create = [](const Parameters& parameters, const SampleRequest& request, Engine engine,
                          const DeviceProvider& device) {
            const SamplerChoice& from = parameters.sampler("start");
            return from.spec->create(from.parameters, request, engine, device);
        };
        SamplerRegistry all = sampler_registry();
        all.push_back(relax);
        return all;
    }();
    return registry;
}

}
