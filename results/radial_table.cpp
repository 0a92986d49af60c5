#include "results/radial_table.hpp"

#include "base/files/number_table.hpp"

#include <algorithm>

namespace poissonlab {

std::vector<RadialBin> read_radial_table(const std::filesystem::path& path)
{
    std::vector<RadialBin> bins;
    for (const auto& row : read_number_table(path, "frequency,power,anisotropy_db,samples,power_error", "frequencies"))
        bins.push_back({row[0], row[1], row[2], table_count(row[3], path, bins.size(), "samples"), row[4]});
    return bins;
}

RadialBin peak_power(const std::vector<RadialBin>& bins)
{
    return *std::ranges::max_element(bins, {}, &RadialBin::power);
}

}
