// poissonlab samplers: what a [[method]] table can say, from the samplers' own descriptions.
#include "app/commands/command.hpp"
#include "host/config/sampler_registry.hpp"
#include "host/config/sampler_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace poissonlab {
namespace {

void print_samplers()
{
    fmt::print("Samplers of a [[method]] table, and their parameters. A list of values makes one series a value.\n"
               "Every table can have\n    label = a text in quotes\n        what the report calls the series\n"
               "    {} = {}\n        {}\n",
               points_parameter().key, allowed_values(points_parameter()), points_parameter().help);
    for (const SamplerSpec& sampler : sampler_registry()) {
        fmt::print("\n{}: {} ({}D{})\n    {}\n", sampler.name, sampler.title, fmt::join(sampler.dimensions, "D, "),
                   sampler.deterministic ? ", deterministic" : "", sampler.summary);
        for (const ParameterSpec& parameter : sampler.parameters)
            fmt::print("    {} = {}\n        {}\n", parameter.key, allowed_values(parameter), parameter.help);
    }
}

}

Command samplers_command()
{
    return {"samplers", "List the methods of making point sets and their parameters", {}, "", [] {
                print_samplers();
                return 0;
            }};
}

}
