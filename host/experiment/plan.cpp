#include "experiment/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace poissonlab {
namespace {

constexpr std::size_t max_series = 1000;
constexpr std::size_t longest_name = 100;

/// One choice of each setting of a method, in the settings' order.
using Combination = std::vector<const ParameterChoice*>;

/// Every combination of choices; the last setting varies fastest.
std::vector<Combination> combinations(const MethodConfig& method)
{
    std::vector<Combination> result = {{}};
    for (const ParameterSetting& setting : method.settings) {
        if (result.size() * setting.choices.size() > max_series)
            throw InputError(fmt::format("{}: [[method]]: its lists make more than {} series",
                                         to_string(method.where), max_series));
        std::vector<Combination> longer;
        for (const Combination& start : result)
            for (const ParameterChoice& choice : setting.choices) {
                longer.push_back(start);
                longer.back().push_back(&choice);
            }
        result = std::move(longer);
    }
    return result;
}

std::string symbol(const ParameterSpec& spec) { return spec.symbol.empty() ? spec.key : spec.symbol; }

/// For example "dart-throwing-rho-0.70".
std::string series_name(const MethodConfig& method, const Combination& chosen)
{
    std::string name = method.sampler->name;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const ParameterSpec& spec = *method.settings[i].parameter;
        // Of paths the file's name says enough.
        const std::string value = spec.kind == ParameterSpec::Kind::paths
                                      ? std::filesystem::path(chosen[i]->shown).stem().string()
                                      : chosen[i]->shown;
        name += fmt::format("-{}-{}", symbol(spec), value);
    }
    return safe_name(name).substr(0, longest_name);
}

/// For example "Dart throwing, rho = 0.70": the user's label and what varies, or the title and all
/// parameters.
std::string series_label(const MethodConfig& method, const Combination& chosen)
{
    std::string label = method.label.empty() ? method.sampler->title : method.label;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const ParameterSetting& setting = method.settings[i];
        if (!method.label.empty() && setting.choices.size() == 1) continue;
        label += fmt::format(", {} = {}", symbol(*setting.parameter), chosen[i]->shown);
    }
    return label;
}

bool same_parameters(const Parameters& a, const Parameters& b)
{
    return std::ranges::equal(a.entries(), b.entries(), [](const auto& x, const auto& y) {
        return x.first == y.first && x.second.value == y.second.value;
    });
}

SeriesPlan make_series(const Config& config, const MethodConfig& method, const Combination& chosen)
{
    SeriesPlan series;
    series.name = series_name(method, chosen);
    series.label = series_label(method, chosen);
    series.sampler = method.sampler;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        series.parameters.set(method.settings[i].parameter->key, chosen[i]->value, chosen[i]->location);
    series.request = {config.points, config.dimension, config.seed};

    const SamplerSpec& sampler = *method.sampler;
    if (std::ranges::find(sampler.dimensions, config.dimension) == sampler.dimensions.end())
        throw InputError(fmt::format("{}: sampler = \"{}\": this method has no {}D sets",
                                     to_string(method.where), sampler.name, config.dimension));
    if (sampler.check) sampler.check(series.parameters, series.request, method.where);

    series.realizations = static_cast<std::uint32_t>(config.realizations);
    if (sampler.available_realizations)
        series.realizations = static_cast<std::uint32_t>(sampler.available_realizations(series.parameters));
    else if (sampler.deterministic)
        series.realizations = 1;
    return series;
}

}

std::vector<SeriesPlan> make_plan(const Config& config)
{
    std::vector<SeriesPlan> plan;
    std::set<std::string> names;
    for (const MethodConfig& method : config.methods) {
        for (const Combination& chosen : combinations(method)) {
            SeriesPlan series = make_series(config, method, chosen);
            for (const SeriesPlan& other : plan)
                if (other.sampler == series.sampler && same_parameters(other.parameters, series.parameters))
                    throw InputError(fmt::format("{}: [[method]]: the series \"{}\" is there twice",
                                                 to_string(method.where), other.label));
            if (plan.size() == max_series)
                throw InputError(
                    fmt::format("{}: the config makes more than {} series", config.file, max_series));
            // Different series whose names were cut or cleaned to the same get a number.
            const std::string base = series.name;
            for (int number = 2; !names.insert(series.name).second; ++number)
                series.name = fmt::format("{}-{}", base, number);
            plan.push_back(std::move(series));
        }
    }
    return plan;
}

std::string safe_name(const std::string& text)
{
    std::string name;
    for (const char c : text) {
        const bool safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          c == '.' || c == '_' || c == '-';
        if (safe)
            name += c;
        else if (name.empty() || name.back() != '-')
            name += '-';
    }
    const std::size_t first = name.find_first_not_of("-.");
    if (first == std::string::npos) return "series";
    return name.substr(first, name.find_last_not_of('-') - first + 1);
}

}
