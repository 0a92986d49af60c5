// Configs: TOML text, with `--set` arguments on lines that begin with `#--set `. What is accepted is planned as well.
#include "base/files/text_lines.hpp"
#include "experiment/config/config.hpp"
#include "experiment/config/plan.hpp"
#include "tests/fuzz/fuzz_support.hpp"

#include <algorithm>
#include <memory>

namespace poissonlab::fuzz {
namespace {

std::vector<std::string> overrides_in(std::string_view text)
{
    constexpr std::string_view mark = "#--set ";
    std::vector<std::string> overrides;
    for (LineReader lines(text); lines.next();)
        if (lines.line().starts_with(mark)) overrides.emplace_back(lines.line().substr(mark.size()));
    return overrides;
}

/// True if planning a sampler looks at files and programs of this machine.
bool looks_outside(const SamplerSpec& sampler) { return sampler.name == "file" || sampler.name == "command"; }

bool looks_outside(const ParameterValue& value)
{
    const SamplerChoice* start = as_sampler(value);
    if (!start) return false;
    return looks_outside(*start->spec) || std::ranges::any_of(start->parameters.given(), [](const auto& entry) {
               return looks_outside(entry.second.value);
           });
}

bool looks_outside(const MethodConfig& method)
{
    if (looks_outside(*method.sampler)) return true;
    for (const ParameterSetting& setting : method.settings)
        for (const ParameterChoice& choice : setting.choices)
            if (looks_outside(choice.value)) return true;
    return false;
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto overrides = fuzz::overrides_in(text);

    // An error of an argument has its place there.
    const std::string place = overrides.empty() ? "c.toml" : "";
    Config config;
    if (!fuzz::accepts(place, [&] { config = parse_config(text, "c.toml", overrides); })) return 0;
    if (std::ranges::any_of(config.methods, [](const MethodConfig& m) { return fuzz::looks_outside(m); })) return 0;
    std::vector<SeriesPlan> plan;
    if (!fuzz::accepts(place, [&] { plan = make_plan(config); })) return 0;
    for (const SeriesPlan& series : plan) {
        fuzz::require(safe_name(series.name) == series.name, "a series whose name is no name of a folder");
        fuzz::require(!series.label.empty(), "a series without a label");
    }
    return 0;
}
