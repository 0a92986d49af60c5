#include "results/result_tables.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::string radial_csv(const std::vector<RadialBin>& bins)
{
    std::string text = "frequency,power,anisotropy_db,samples,power_error\n";
    for (const RadialBin& bin : bins)
        text +=
            fmt::format("{},{},{},{},{}\n", bin.frequency, bin.power, bin.anisotropy_db, bin.samples, bin.power_error);
    return text;
}

std::string pair_correlation_csv(const std::vector<PairCorrelationBin>& bins)
{
    std::string text = "distance,pair_correlation,standard_error,pairs\n";
    for (const PairCorrelationBin& bin : bins)
        text += fmt::format("{},{},{},{}\n", bin.distance, bin.value, bin.standard_error, bin.pairs);
    return text;
}

}
