#include "results/run.hpp"

namespace poissonlab {

std::vector<std::pair<std::string, std::string>> Machine::used() const
{
    const auto number = [](auto value) { return value == 0 ? "" : std::to_string(value); };
    std::vector<std::pair<std::string, std::string>> members{{"compute_units", number(compute_units)},
                                                             {"device", device},
                                                             {"device_version", device_version},
                                                             {"driver", driver},
                                                             {"platform", platform},
                                                             {"processes", number(processes)},
                                                             {"threads", number(threads)}};
    std::erase_if(members, [](const auto& member) { return member.second.empty(); });
    return members;
}

std::string Machine::text(const std::string& name) const
{
    for (const auto& [key, value] : used())
        if (key == name) return value;
    return {};
}

}
