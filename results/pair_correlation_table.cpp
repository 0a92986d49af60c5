#include "results/pair_correlation_table.hpp"

#include "base/errors/errors.hpp"
#include "base/files/number_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {

namespace {

constexpr const char* pair_correlation_header = "distance,pair_correlation,standard_error,pairs";

}

std::string pair_correlation_csv(const std::vector<PairCorrelationBin>& bins)
{
    std::string text = fmt::format("{}\n", pair_correlation_header);
    for (const PairCorrelationBin& bin : bins)
        text += fmt::format("{},{},{},{}\n", bin.distance, bin.value, bin.standard_error, bin.pairs);
    return text;
}

std::vector<PairCorrelationBin> read_pair_correlation_table(const std::filesystem::path& path)
{
    std::vector<PairCorrelationBin> bins;
    for (const auto& row : read_number_table(path, pair_correlation_header, "distances")) {
        if (!std::isfinite(row[2]) || !std::isfinite(row[3]))
            throw InputError(fmt::format("{}:{}: standard_error = {}, pairs = {}: must be finite", path.string(),
                                         bins.size() + 2, row[2], row[3]));
        bins.push_back({row[0], row[1], row[2], row[3]});
    }
    return bins;
}

}
