// poissonlab samplers: what a [[method]] table can say, from the samplers' own descriptions.
#include "app/commands/core/described_values.hpp"
#include "app/commands/core/stored_text.hpp"
#include "app/commands/work_options.hpp"
#include "host/modules/laboratory.hpp"
#include "host/sampling/guide/sampler_guide.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_help.hpp"
#include "host/settings/sampler_registry.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

nlohmann::ordered_json described_samplers(const SamplerRegistry& samplers)
{
    auto list = nlohmann::ordered_json::array();
    for (const SamplerSpec& sampler : samplers) {
        auto parameters = nlohmann::ordered_json::array();
        for (const ParameterSpec& spec : sampler.parameters)
            parameters.push_back(described_value(spec, allowed_values(spec)));
        list.push_back({{"name", sampler.name},
                        {"title", sampler.title},
                        {"summary", sampler.summary},
                        {"source", sampler_guide(sampler.name).source},
                        {"dimensions", sampler.dimensions},
                        {"deterministic", sampler.deterministic},
                        {"parameters", parameters}});
    }
    return list;
}

void print_samplers_json()
{
    need_all_modules();
    const nlohmann::ordered_json json{{"samplers", described_samplers(sampler_registry())},
                                      {"in_regions", described_samplers(region_sampler_registry())}};
    fmt::print("{}\n", json.dump(2));
}

std::string all_samplers_markdown()
{
    need_all_modules();
    return samplers_markdown(sampler_registry()) + "\n" + samplers_markdown(region_sampler_registry());
}

std::string all_samplers_text()
{
    if (!has_all_modules()) return std::string(stored_text("samplers.txt"));
    return samplers_text(sampler_registry(), region_sampler_registry());
}

}

Command samplers_command()
{
    const auto markdown = std::make_shared<bool>(false), as_json = std::make_shared<bool>(false);
    return {"samplers",
            "List the methods of making point sets and their parameters",
            {{"--markdown", markdown.get(), "Print the tables of docs/samplers.md"}, json_option(*as_json)},
            "",
            [markdown, as_json] {
                if (*as_json)
                    print_samplers_json();
                else
                    fmt::print("{}", *markdown ? all_samplers_markdown() : all_samplers_text());
                return 0;
            }};
}

}
