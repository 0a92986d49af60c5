#include "results/zone_plate_table.hpp"

#include "base/errors/errors.hpp"
#include "base/files/number_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {

namespace {

constexpr const char* zone_plate_header = "distance,frequency,rms_error,pixels";

}

std::string zone_plate_csv(const std::vector<ErrorBin>& bins)
{
    std::string text = fmt::format("{}\n", zone_plate_header);
    for (const ErrorBin& bin : bins)
        text += fmt::format("{},{},{},{}\n", bin.distance, bin.frequency, bin.rms_error, bin.pixels);
    return text;
}

std::vector<ErrorBin> read_zone_plate_table(const std::filesystem::path& path)
{
    std::vector<ErrorBin> bins;
    for (const auto& row : read_number_table(path, zone_plate_header, "distances")) {
        if (!std::isfinite(row[2]))
            throw InputError(
                fmt::format("{}:{}: rms_error = {}: must be finite", path.string(), bins.size() + 2, row[2]));
        bins.push_back({row[0], row[1], row[2], table_count(row[3], path, bins.size(), "pixels")});
    }
    return bins;
}

}
