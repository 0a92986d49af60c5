#include "host/sampling/parameters.hpp"

#include "host/sampling/sampler.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace poissonlab {

std::string to_string(const ParameterValue& value)
{
    struct Visitor
    {
        std::string operator()(double v) const { return fmt::format("{}", v); }
        std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
        std::string operator()(bool v) const { return v ? "true" : "false"; }
        std::string operator()(const std::string& v) const { return v; }
        std::string operator()(const std::vector<std::string>& v) const
        {
            return fmt::format("{}", fmt::join(v, ", "));
        }
        std::string operator()(const std::shared_ptr<const SamplerChoice>& v) const
        {
            std::string text = "{ sampler = " + v->spec->name;
            for (const auto& [key, entry] : v->parameters.given())
                text += fmt::format(", {} = {}", key, to_string(entry.value));
            return text + " }";
        }
    };
    return std::visit(Visitor{}, value);
}

const SamplerChoice* as_sampler(const ParameterValue& value)
{
    const auto* sampler = std::get_if<std::shared_ptr<const SamplerChoice>>(&value);
    return sampler ? sampler->get() : nullptr;
}

bool same_value(const ParameterValue& a, const ParameterValue& b)
{
    const SamplerChoice* left = as_sampler(a);
    const SamplerChoice* right = as_sampler(b);
    if (!left || !right) return a == b;
    return left->spec->name == right->spec->name && same_parameters(left->parameters, right->parameters);
}

bool same_parameters(const Parameters& a, const Parameters& b)
{
    return std::ranges::equal(a.given(), b.given(), [](const auto& x, const auto& y) {
        return x.first == y.first && same_value(x.second.value, y.second.value);
    });
}

Parameters::Parameters(const std::vector<ParameterSpec>& specs)
{
    for (const ParameterSpec& spec : specs)
        if (spec.otherwise) defaults_[spec.key] = *spec.otherwise;
}

void Parameters::set(const std::string& key, ParameterValue value, SourceLocation location)
{
    given_[key] = {std::move(value), std::move(location)};
    defaults_.erase(key);
}

const ParameterValue& Parameters::at(const std::string& key) const
{
    if (const auto entry = given_.find(key); entry != given_.end()) return entry->second.value;
    if (const auto entry = defaults_.find(key); entry != defaults_.end()) return entry->second;
    throw std::logic_error("parameter without a value: " + key);
}

double Parameters::number(const std::string& key) const { return std::get<double>(at(key)); }
std::int64_t Parameters::integer(const std::string& key) const { return std::get<std::int64_t>(at(key)); }
bool Parameters::flag(const std::string& key) const { return std::get<bool>(at(key)); }
const std::string& Parameters::text(const std::string& key) const { return std::get<std::string>(at(key)); }
const std::vector<std::string>& Parameters::texts(const std::string& key) const
{
    return std::get<std::vector<std::string>>(at(key));
}
const SamplerChoice& Parameters::sampler(const std::string& key) const
{
    return *std::get<std::shared_ptr<const SamplerChoice>>(at(key));
}

InputError Parameters::error(const std::string& key, const std::string& allowed) const
{
    const ParameterValue& value = at(key);
    const bool is_text = std::holds_alternative<std::string>(value);
    return invalid_value(location(key), key, is_text ? fmt::format("\"{}\"", to_string(value)) : to_string(value),
                         allowed);
}

}
