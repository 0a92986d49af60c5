#include "host/settings/sampler_texts.hpp"

#include "host/sampling/guide/sampler_guide.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_help.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace poissonlab {
namespace {

/// The value or rule that holds where a parameter is not given, as a part of a sentence.
std::string without_it(const ParameterSpec& spec)
{
    if (spec.otherwise) return "default " + default_text(spec);
    return spec.unless_given.empty() ? "needed" : spec.unless_given;
}

std::string parameter_text(const ParameterSpec& spec)
{
    return fmt::format("    {} = {}\n        {}; {}\n", spec.key, allowed_values(spec), meaning_of(spec),
                       without_it(spec));
}

std::string parameter_row(const ParameterSpec& spec)
{
    return fmt::format("| `{}` | {} | {} | {} |\n", spec.key, braces_as_code(allowed_values(spec)),
                       spec.otherwise ? default_text(spec) : without_it(spec), meaning_of(spec));
}

/// "2D, 3D, device memory ~ N"
std::string traits_of(const SamplerSpec& sampler)
{
    std::string traits = fmt::format("{}D", fmt::join(sampler.dimensions, "D, "));
    if (sampler.deterministic) traits += ", deterministic";
    if (sampler.memory_growth != MemoryGrowth::none)
        traits += fmt::format(", {}", memory_growths[sampler.memory_growth]);
    return traits;
}

}

std::string braces_as_code(const std::string& text)
{
    std::string code;
    for (const char letter : text) code += letter == '{' ? "`{" : letter == '}' ? "}`" : std::string(1, letter);
    return code;
}

std::string samplers_text(const SamplerRegistry& all, const SamplerRegistry& in_regions)
{
    std::string text =
        "Samplers of a [[method]] table, and their parameters. A list of values makes one series a "
        "value.\nEvery table can have\n    label = a line of text in quotes\n        what the report calls the "
        "series\n" +
        parameter_text(points_parameter()) + parameter_text(order_parameter()) +
        "    region = a file of GeoJSON, WKT or pixels, or a description such as \"disk 0 0 50\", in quotes\n        "
        "where points lie, instead of the unit square; planar = true says that it is not in degrees\n";
    for (const SamplerSpec& sampler : all) {
        const SamplerGuide& guide = sampler_guide(sampler.name);
        text += fmt::format("\n{}: {} ({})\n    {}\n    Source: {}\n    When to use it: {}\n    When not: {}\n",
                            sampler.name, sampler.title, traits_of(sampler), sampler.summary, guide.source, guide.use,
                            guide.avoid);
        for (const ParameterSpec& parameter : sampler.parameters) text += parameter_text(parameter);
    }
    text += "\nIn a region, of the method or of [analysis], samplers and their parameters are these:\n";
    for (const SamplerSpec& sampler : in_regions) {
        text += fmt::format("\n{}: {}\n    {}\n", sampler.name, sampler.title, sampler.summary);
        for (const ParameterSpec& parameter : sampler.parameters) text += parameter_text(parameter);
    }
    return text;
}

std::string parameters_markdown(const SamplerSpec& sampler)
{
    std::string text = "| parameter | | default | |\n| --- | --- | --- | --- |\n";
    for (const ParameterSpec& parameter : sampler.parameters) text += parameter_row(parameter);
    return text;
}

std::string samplers_markdown(const SamplerRegistry& samplers)
{
    std::string text = "| sampler, parameters | | default | |\n| --- | --- | --- | --- |\n";
    std::map<std::string, std::string> shown; // rows, and the sampler that had them first
    for (const SamplerSpec& sampler : samplers) {
        text += fmt::format("| **`{}`** | {} | | {} |\n", sampler.name, traits_of(sampler), sampler.summary);
        std::map<std::string, std::vector<std::string>> same_as; // samplers, and the parameters that are theirs as well
        for (const ParameterSpec& parameter : sampler.parameters) {
            const std::string row = parameter_row(parameter);
            const auto [first, is_new] = shown.try_emplace(row, sampler.name);
            if (is_new)
                text += row;
            else
                same_as[first->second].push_back(parameter.key);
        }
        for (const auto& [other, keys] : same_as)
            text += fmt::format("| `{}` | as of `{}` | | |\n", fmt::join(keys, "`, `"), other);
    }
    return text;
}

}
