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
            for (const auto& [key, entry] : v->parameters.entries())
                text += fmt::format(", {} = {}", key, to_string(entry.value));
            return text + " }";
        }
    };
    return std::visit(Visitor{}, value);
}

bool same_value(const ParameterValue& a, const ParameterValue& b)
{
    using Pointer = std::shared_ptr<const SamplerChoice>;
    const auto* left = std::get_if<Pointer>(&a);
    const auto* right = std::get_if<Pointer>(&b);
    if (!left || !right) return a == b;
    return (*left)->spec->name == (*right)->spec->name && same_parameters((*left)->parameters, (*right)->parameters);
}

bool same_parameters(const Parameters& a, const Parameters& b)
{
    return std::ranges::equal(a.entries(), b.entries(), [](const auto& x, const auto& y) {
        return x.first == y.first && same_value(x.second.value, y.second.value);
    });
}

void Parameters::set(const std::string& key, ParameterValue value, SourceLocation location)
{
    entries_[key] = {std::move(value), std::move(location)};
}

const Parameters::Entry& Parameters::at(const std::string& key) const
{
    const auto entry = entries_.find(key);
    if (entry == entries_.end()) throw std::logic_error("parameter not set: " + key);
    return entry->second;
}

double Parameters::number(const std::string& key) const { return std::get<double>(at(key).value); }
std::int64_t Parameters::integer(const std::string& key) const { return std::get<std::int64_t>(at(key).value); }
bool Parameters::flag(const std::string& key) const { return std::get<bool>(at(key).value); }
const std::string& Parameters::text(const std::string& key) const { return std::get<std::string>(at(key).value); }
const std::vector<std::string>& Parameters::texts(const std::string& key) const
{
    return std::get<std::vector<std::string>>(at(key).value);
}
const SamplerChoice& Parameters::sampler(const std::string& key) const
{
    return *std::get<std::shared_ptr<const SamplerChoice>>(at(key).value);
}
const SourceLocation& Parameters::location(const std::string& key) const { return at(key).location; }

InputError Parameters::error(const std::string& key, const std::string& allowed) const
{
    return invalid_value(location(key), key, to_string(at(key).value), allowed);
}

}
