// The settings of a kind of work, checked: see host/kinds/kind.hpp.
#pragma once

#include <any>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Settings of whatever kind, and what is known of them without it.
struct KindSettings
{
    std::any values;      ///< of the kind's own type
    std::string label;    ///< of a result, where nobody gave another one
    std::string resolved; ///< keys and values, in one line: what decides the result, but for `inputs`
    std::vector<std::filesystem::path> inputs; ///< files that decide it as well

    template <class Settings>
    const Settings& as() const
    {
        return std::any_cast<const Settings&>(values);
    }
};

}
