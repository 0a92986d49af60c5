#include "results/series.hpp"

#include "analysis/borders/border_pairs.hpp"
#include "base/errors/errors.hpp"
#include "base/files/number_table.hpp"
#include "base/files/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numeric>

namespace poissonlab {
namespace {

constexpr const char* table_header = "realization,iteration,relative_radius,energy";
constexpr const char* header_with_tiles = "realization,iteration,relative_radius,energy,relative_radius_within_tiles";

/// True if all records have a radius within tiles.
bool have_tiles(const IterationRecords& records)
{
    return !records.empty() && !records.front().empty() && std::ranges::all_of(records, [](const auto& realization) {
        return std::ranges::all_of(
            realization, [](const IterationRecord& record) { return record.relative_radius_within_tiles.has_value(); });
    });
}

/// The header of a stored table; of those that are none the usual one, for complaints.
std::string header_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line == header_with_tiles ? header_with_tiles : table_header;
}

}

std::string iterations_csv(const IterationRecords& records)
{
    const bool with_tiles = have_tiles(records);
    std::string text = fmt::format("{}\n", with_tiles ? header_with_tiles : table_header);
    for (std::size_t k = 0; k < records.size(); ++k)
        for (std::size_t i = 0; i < records[k].size(); ++i) {
            const IterationRecord& record = records[k][i];
            text += fmt::format("{},{},{:.17g},{:.17g}", k, i, record.relative_radius, record.energy);
            if (with_tiles) text += fmt::format(",{:.17g}", *record.relative_radius_within_tiles);
            text += '\n';
        }
    return text;
}

IterationRecords read_iterations_table(const std::filesystem::path& path)
{
    IterationRecords records;
    std::size_t number = 0;
    for (const auto& row : read_number_table(path, header_of(path), "iterations")) {
        const std::size_t realization = table_count(row[0], path, number, "realization");
        const std::size_t iteration = table_count(row[1], path, number, "iteration");
        ++number;
        if (iteration == 0 && realization == records.size()) records.emplace_back();
        if (realization + 1 != records.size() || iteration != records.back().size())
            throw InputError(fmt::format("{}:{}: realization {}, iteration {} must follow on those before",
                                         path.string(), number + 1, realization, iteration));
        records.back().push_back({row[2], row[3], row.size() > 4 ? std::optional(row[4]) : std::nullopt});
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

/// The spread of a number of all records, over so many iterations.
template <class Number>
IterationSpread spread_of(const IterationRecords& records, const Number& number_of, std::size_t iterations)
{
    IterationSpread spread;
    for (std::size_t i = 0; i < iterations; ++i) {
        std::vector<double> values;
        for (const auto& realization : records)
            if (i < realization.size()) values.push_back(std::invoke(number_of, realization[i]));
        const double sum = std::accumulate(values.begin(), values.end(), 0.0);
        spread.min.push_back(std::ranges::min(values));
        spread.mean.push_back(sum / static_cast<double>(values.size()));
        spread.max.push_back(std::ranges::max(values));
    }
    return spread;
}

bool is_finite(const IterationRecord& record)
{
    return std::isfinite(record.relative_radius) && std::isfinite(record.energy) &&
           std::isfinite(record.relative_radius_within_tiles.value_or(0));
}

}

std::optional<Iterations> iterations_of(const IterationRecords& records)
{
    const auto counts = realizations_that_got_there(records);
    if (counts.empty()) return std::nullopt;
    for (const auto& realization : records)
        if (!std::ranges::all_of(realization, is_finite)) return Iterations{};
    Iterations iterations{{},
                          counts,
                          spread_of(records, &IterationRecord::relative_radius, counts.size()),
                          spread_of(records, &IterationRecord::energy, counts.size()),
                          {}};
    const auto within = [](const IterationRecord& record) { return *record.relative_radius_within_tiles; };
    if (have_tiles(records)) iterations.relative_radius_within_tiles = spread_of(records, within, counts.size());
    return iterations;
}

bool BorderResult::is_not_periodic() const { return chance < least_chance_across; }

std::string border_words(const Series& series)
{
    if (!series.border || !series.border->is_not_periodic()) return {};
    const BorderResult& border = *series.border;
    return fmt::format(
        "The closest pairs of points meet across the border ({} pairs are closer than any two inside): the "
        "sets are not periodic, and are measured as if they were. Without wrapping, the relative radius "
        "is {:.3f} and the mean nearest distance {:.3f}.",
        border.pairs_across, border.relative_radius, border.mean_nearest_distance);
}

std::string border_advice(int dimension)
{
    return fmt::format(
        "To measure them without wrapping{}: poissonlab analyze --periodic no; in a config {}; in Python "
        "periodic=False. If they are periodic: --periodic yes, periodic=True.",
        dimension == 2 ? "" : ", which needs a cube",
        dimension == 2 ? "region = \"rectangle 0 0 1 1\" in the [[method]]" : "window = true under [analysis]");
}

/// The distance from a random point to the nearest other one has a standard deviation of 0.523 of its mean (Clark and
/// Evans 1954; 0.363 in space), and its mean over N points one of 0.523 / root N, or a little more as points share
/// distances. Methods that keep points apart vary less. A few percent are nothing to warn of, however large sets are.
std::string mixture_words(const Series& series)
{
    constexpr double random_deviation = 0.523, times_random = 4, least_told = 0.03;
    const auto found = series.measures.numbers.find("mean_nearest_distance");
    if (found == series.measures.numbers.end() || !found->second.standard_error) return {};
    const double deviation = *found->second.standard_error * std::sqrt(series.realizations) / found->second.value;
    const double random = random_deviation / std::sqrt(static_cast<double>(series.points));
    if (!(deviation > std::max(times_random * random, least_told))) return {};
    const auto percent = [](double part) {
        return part < 0.1 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
    };
    return fmt::format("The sets differ from each other more than sets of one method do: the standard deviation of "
                       "their mean nearest distances is {}; sets of random points have {}. If several "
                       "methods made them, analyze the sets of each method alone, or give each method a [[method]] "
                       "table in a config (sampler = \"file\"), so that the report compares them.",
                       percent(deviation), percent(random));
}

double BoxResult::unit_length() const { return root_of_volume(sides); }

PeriodicBox BoxResult::box() const { return periodic_box(sides); }

bool is_followed_density(const std::string& key, const std::string& text)
{
    double number = 0;
    return key == "density" && !parse_number(text, number);
}

double spectrum_reach(const Series& series)
{
    const double half = series.spectrum_size / 2;
    return series.box ? half / series.box->box().longest() : half;
}

bool Series::is_repeated(std::size_t realization) const { return std::ranges::binary_search(repeated, realization); }

void Series::set_sizes(const std::vector<std::size_t>& sizes)
{
    const std::size_t count = sizes.size();
    const std::size_t total = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
    realizations = static_cast<int>(count);
    points = count > 0 ? (total + count / 2) / count : 0;
    points_each.clear();
    if (std::ranges::adjacent_find(sizes, std::ranges::not_equal_to{}) != sizes.end()) points_each = sizes;
}

}
