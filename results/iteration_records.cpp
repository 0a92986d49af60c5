#include "results/iteration_records.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

std::string iterations_csv(const IterationRecords& records)
{
    std::string text = "realization,iteration,relative_radius,energy\n";
    for (std::size_t k = 0; k < records.size(); ++k)
        for (std::size_t i = 0; i < records[k].size(); ++i)
            text += fmt::format("{},{},{:.17g},{:.17g}\n", k, i, records[k][i].relative_radius, records[k][i].energy);
    return text;
}

std::vector<std::size_t> realizations_that_got_there(const IterationRecords& records)
{
    std::vector<std::size_t> counts;
    for (const auto& realization : records) {
        counts.resize(std::max(counts.size(), realization.size()));
        for (std::size_t i = 0; i < realization.size(); ++i) ++counts[i];
    }
    return counts;
}

IterationSpread spread_over_realizations(const IterationRecords& records, double IterationRecord::*member)
{
    IterationSpread spread;
    const auto counts = realizations_that_got_there(records);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        std::vector<double> values;
        for (const auto& realization : records)
            if (i < realization.size()) values.push_back(realization[i].*member);
        double sum = 0;
        for (const double value : values) sum += value;
        spread.min.push_back(std::ranges::min(values));
        spread.mean.push_back(sum / static_cast<double>(values.size()));
        spread.max.push_back(std::ranges::max(values));
    }
    return spread;
}

}
