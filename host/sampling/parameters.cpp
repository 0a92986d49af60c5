#include "sampling/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace poissonlab {

std::string to_string(const ParameterValue& value)
{
    struct Visitor
    {
        std::string operator()(double v) const { return fmt::format("{}", v); }
        std::string operator()(std::int64_t v) const { return fmt::format("{}", v); }
        std::string operator()(const std::string& v) const { return v; }
        std::string operator()(const std::vector<std::string>& v) const
        {
            return fmt::format("{}", fmt::join(v, ", "));
        }
    };
    return std::visit(Visitor{}, value);
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
std::int64_t Parameters::integer(const std::string& key) const
{
    return std::get<std::int64_t>(at(key).value);
}
const std::string& Parameters::text(const std::string& key) const
{
    return std::get<std::string>(at(key).value);
}
const std::vector<std::string>& Parameters::texts(const std::string& key) const
{
    return std::get<std::vector<std::string>>(at(key).value);
}
const SourceLocation& Parameters::location(const std::string& key) const { return at(key).location; }

InputError Parameters::error(const std::string& key, const std::string& allowed) const
{
    return invalid_value(location(key), key, to_string(at(key).value), allowed);
}

}
