#include "reports/zone_plate_table.hpp"

#include "errors/errors.hpp"
#include "reports/number_table.hpp"

#include <cmath>
#include <string>

namespace poissonlab {

std::vector<ErrorBin> read_zone_plate_table(const std::filesystem::path& path)
{
    std::vector<ErrorBin> bins;
    for (const auto& [distance, frequency, error, pixels] :
         read_number_table(path, "distance,frequency,rms_error,pixels", "distances")) {
        if (!std::isfinite(error) || !std::isfinite(pixels))
            throw InputError(path.string() + ":" + std::to_string(bins.size() + 2) +
                             ": errors and numbers of pixels must be finite");
        bins.push_back({distance, frequency, error, static_cast<std::size_t>(pixels)});
    }
    return bins;
}

}
