#include "results/iteration_records.hpp"

#include "base/errors/errors.hpp"
#include "base/files/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

constexpr const char* table_header = "realization,iteration,relative_radius,energy";

}

std::string iterations_csv(const IterationRecords& records)
{
    std::string text = fmt::format("{}\n", table_header);
    for (std::size_t k = 0; k < records.size(); ++k)
        for (std::size_t i = 0; i < records[k].size(); ++i)
            text += fmt::format("{},{},{:.17g},{:.17g}\n", k, i, records[k][i].relative_radius, records[k][i].energy);
    return text;
}

IterationRecords read_iterations_table(const std::filesystem::path& path)
{
    IterationRecords records;
    std::size_t number = 0;
    for (const auto& row : read_number_table(path, table_header, "iterations")) {
        const std::size_t realization = table_count(row[0], path, number, "realization");
        const std::size_t iteration = table_count(row[1], path, number, "iteration");
        ++number;
        if (iteration == 0 && realization == records.size()) records.emplace_back();
        if (realization + 1 != records.size() || iteration != records.back().size())
            throw InputError(fmt::format("{}:{}: realization {}, iteration {} must follow on those before",
                                         path.string(), number + 1, realization, iteration));
        records.back().push_back({row[2], row[3]});
    }
    return records;
}

namespace {

std::vector<std::size_t> realizations_that_got_there(const IterationRecords& records)
{
    std::vector<std::size_t> counts;
    for (const auto& realization : records) {
        counts.resize(std::max(counts.size(), realization.size()));
        for (std::size_t i = 0; i < realization.size(); ++i) ++counts[i];
    }
    return counts;
}

/// The spread of a member of all records, over so many iterations.
IterationSpread spread_of(const IterationRecords& records, double IterationRecord::*member, std::size_t iterations)
{
    IterationSpread spread;
    for (std::size_t i = 0; i < iterations; ++i) {
        std::vector<double> values;
        for (const auto& realization : records)
            if (i < realization.size()) values.push_back(realization[i].*member);
        const double sum = std::accumulate(values.begin(), values.end(), 0.0);
        spread.min.push_back(std::ranges::min(values));
        spread.mean.push_back(sum / static_cast<double>(values.size()));
        spread.max.push_back(std::ranges::max(values));
    }
    return spread;
}

bool is_finite(const IterationRecord& record)
{
    return std::isfinite(record.relative_radius) && std::isfinite(record.energy);
}

}

std::optional<Iterations> iterations_of(const IterationRecords& records)
{
    const auto counts = realizations_that_got_there(records);
    if (counts.empty()) return std::nullopt;
    for (const auto& realization : records)
        if (!std::ranges::all_of(realization, is_finite)) return Iterations{};
    return Iterations{{},
                      counts,
                      spread_of(records, &IterationRecord::relative_radius, counts.size()),
                      spread_of(records, &IterationRecord::energy, counts.size())};
}

}
