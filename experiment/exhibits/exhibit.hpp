// A config asks for more than methods: each table [[construction]], [[distribution]], ... is an exhibit of a
// kind.
#pragma once

#include "experiment/config/config.hpp"
#include "host/kinds/kind.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

struct Exhibit
{
    const Kind* kind = nullptr;
    KindSettings settings;
    std::string label; ///< never empty
    SourceLocation where;
    std::uint64_t seed = 1;
    std::string name{}; ///< its folder; before an experiment has given each its own: what it would be called

    /// All that decides the result but for the seed and what files hold. A label makes nothing anew.
    std::string identity() const;
};

/// Reads and checks the tables of a config. Throws InputError with the place of what is wrong.
std::vector<Exhibit> read_exhibits(const Config& config);

/// Makes one and writes its files. Throws InputError where it cannot be made, and StorageError.
Exhibited make_exhibit(const Exhibit& exhibit, const DistributionPlace& place, DistributionFiles& files);

/// Throws InputError, with the place of the table, for exhibits that need more memory than the device has.
void check_device_memory(const std::vector<Exhibit>& exhibits, const DeviceInfo& device);

}
