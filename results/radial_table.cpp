#include "results/radial_table.hpp"

#include "base/files/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

constexpr const char* radial_header = "frequency,power,anisotropy_db,samples,power_error";

}

std::string radial_csv(const std::vector<RadialBin>& bins)
{
    std::string text = fmt::format("{}\n", radial_header);
    for (const RadialBin& bin : bins)
        text +=
            fmt::format("{},{},{},{},{}\n", bin.frequency, bin.power, bin.anisotropy_db, bin.samples, bin.power_error);
    return text;
}

std::vector<RadialBin> read_radial_table(const std::filesystem::path& path)
{
    std::vector<RadialBin> bins;
    for (const auto& row : read_number_table(path, radial_header, "frequencies"))
        bins.push_back({row[0], row[1], row[2], table_count(row[3], path, bins.size(), "samples"), row[4]});
    return bins;
}

RadialBin peak_power(const std::vector<RadialBin>& bins)
{
    return *std::ranges::max_element(bins, {}, &RadialBin::power);
}

}
