#include "reports/zone_plate_table.hpp"

#include "errors/errors.hpp"
#include "reports/number_table.hpp"

#include <cmath>
#include <string>

namespace poissonlab {

std::vector<ErrorBin> read_zone_plate_table(const std::filesystem::path& path)
{
    std::vector<ErrorBin> bins;
    for (const auto& row :
         read_number_table(path, "distance,frequency,rms_error,pixels", "distances")) {
        if (!std::isfinite(row[2]) || !std::isfinite(row[3]))
            throw InputError(path.string() + ":" + std::to_string(bins.size() + 2) +
                             ": errors and numbers of pixels must be finite");
        bins.push_back({row[0], row[1], row[2], static_cast<std::size_t>(row[3])});
    }
    return bins;
}

}
