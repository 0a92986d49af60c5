#include "results/pair_correlation_table.hpp"

#include "base/errors/errors.hpp"
#include "base/files/number_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {

std::vector<PairCorrelationBin> read_pair_correlation_table(const std::filesystem::path& path)
{
    std::vector<PairCorrelationBin> bins;
    for (const auto& row : read_number_table(path, "distance,pair_correlation,standard_error,pairs", "distances")) {
        if (!std::isfinite(row[2]) || !std::isfinite(row[3]))
            throw InputError(fmt::format("{}:{}: standard_error = {}, pairs = {}: must be finite", path.string(),
                                         bins.size() + 2, row[2], row[3]));
        bins.push_back({row[0], row[1], row[2], row[3]});
    }
    return bins;
}

}
