#include "reports/radial_table.hpp"

#include "reports/number_table.hpp"

#include <algorithm>

namespace poissonlab {

std::vector<RadialBin> read_radial_table(const std::filesystem::path& path)
{
    std::vector<RadialBin> bins;
    for (const auto& [frequency, power, anisotropy, samples] :
         read_number_table(path, "frequency,power,anisotropy_db,samples", "frequencies"))
        bins.push_back({frequency, power, anisotropy, static_cast<std::size_t>(samples)});
    return bins;
}

RadialBin peak_power(const std::vector<RadialBin>& bins)
{
    return *std::ranges::max_element(bins, {}, &RadialBin::power);
}

}
