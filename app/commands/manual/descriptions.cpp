// A program with all modules prints samplers and kinds from their own descriptions.
#include "app/commands/core/stored_text.hpp"
#include "app/commands/manual/described_values.hpp"
#include "host/kinds/kind_help.hpp"
#include "host/kinds/kinds.hpp"
#include "host/sampling/guide/sampler_guide.hpp"
#include "host/settings/parameter_values.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/settings/sampler_texts.hpp"

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

}

std::string all_samplers_json()
{
    const nlohmann::ordered_json json{{"samplers", described_samplers(sampler_registry())},
                                      {"in_regions", described_samplers(region_sampler_registry())}};
    return json.dump(2) + "\n";
}

std::string all_samplers_markdown()
{
    return samplers_markdown(sampler_registry()) + "\n" + samplers_markdown(region_sampler_registry());
}

std::string all_samplers_text() { return samplers_text(sampler_registry(), region_sampler_registry()); }

std::string all_kinds_json()
{
    nlohmann::ordered_json json{{"kinds", nlohmann::ordered_json::array()}};
    for (const Kind& kind : all_kinds()) {
        auto keys = nlohmann::ordered_json::array();
        for (const KeySpec& spec : kind.keys()) {
            nlohmann::ordered_json key = described_value(spec.value, spec.allowed());
            key["required"] = spec.is_required;
            key["option"] = option_name(spec);
            keys.push_back(std::move(key));
        }
        json["kinds"].push_back({{"table", kind.table},
                                 {"kind", kind.word},
                                 {"command", kind.command},
                                 {"title", kind.title},
                                 {"summary", kind.summary},
                                 {"keys", keys}});
    }
    return json.dump(2) + "\n";
}

std::string all_kinds_markdown() { return kinds_markdown(); }

std::string all_kinds_text() { return kinds_text(); }

}
