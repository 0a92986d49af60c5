// The machine that a run was computed on.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// Empty and zero: not used.
struct Machine
{
    std::string device;
    std::string platform;
    std::string driver;
    std::string device_version;
    unsigned compute_units = 0;
    int threads = 0;
    int processes = 0; ///< that shared the work; 0: one

    bool operator==(const Machine&) const = default;

    /// The members that were used, in alphabetical order.
    std::vector<std::pair<std::string, std::string>> used() const;

    /// The member of that name as text; empty where it was not used.
    std::string text(const std::string& name) const;
};

}
