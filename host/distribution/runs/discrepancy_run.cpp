// kind = "discrepancy": the discrepancy of the first points of sets by methods whose points come in an even order.
#include "base/programs/interrupt.hpp"
#include "host/distribution/discrepancy.hpp"
#include "host/distribution/even_points.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/sampler_registry.hpp"
#include "results/pictures/curve_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::size_t fewest = 16;
constexpr double counts_per_doubling = 4;

struct DiscrepancySettings
{
    std::vector<std::string> methods;
    std::size_t points = 4096;
    std::uint32_t sets = 8;
};

void discrepancy_keys(Keys& keys, DiscrepancySettings& s)
{
    keys.words("methods", s.methods,
               {"random", "sobol", "halton", "best-candidate", "relaxation-dart-throwing", "sample-elimination",
                "dodecagonal"},
               "methods whose first points are sets of their own, with their default parameters")
        .required();
    keys.integer("points", s.points, fewest, 32'768, "the number of points of the largest set");
    keys.integer("sets", s.sets, 2, 256, "the number of sets of each method");
    if (!keys.is_read()) return;
    std::vector<std::string> sorted = s.methods;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) throw keys.invalid("methods", "must have each method once");
    for (const std::string& method : s.methods) find_sampler(method); // throws if its module is absent
}

/// The numbers of points, from the fewest on up to all.
std::vector<std::size_t> counts_up_to(std::size_t points)
{
    std::vector<std::size_t> counts;
    for (int i = 0;; ++i) {
        const auto count = static_cast<std::size_t>(std::lround(fewest * std::exp2(i / counts_per_doubling)));
        if (count >= points) break;
        counts.push_back(count);
    }
    counts.push_back(points);
    return counts;
}

/// Root mean squares over sets, for each number of points.
struct MethodDiscrepancies
{
    std::string name, title;
    std::vector<double> l2, star;
    double l2_error = 0; ///< standard error of the last one

    /// The exponent e of a power law N^e through the values, by least squares of logarithms.
    static double exponent(const std::vector<std::size_t>& counts, const std::vector<double>& values);
};

double MethodDiscrepancies::exponent(const std::vector<std::size_t>& counts, const std::vector<double>& values)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double a = std::log(static_cast<double>(counts[i])), b = std::log(values[i]);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    const auto n = static_cast<double>(counts.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

MethodDiscrepancies measured(const std::string& method, const DiscrepancySettings& s,
                             const std::vector<std::size_t>& counts, std::uint64_t seed, const DistributionPlace& place)
{
    const SamplerSpec& spec = *find_sampler(method);
    const Parameters parameters(spec.parameters);
    const SampleRequest request{s.points, 2, seed, place.on_step};
    if (spec.check) spec.check(parameters, request, {});
    const auto sampler = spec.create(parameters, request, place.engine, place.device);
    MethodDiscrepancies found{method, spec.title, std::vector<double>(counts.size()),
                              std::vector<double>(counts.size())};
    double squares = 0;
    for (std::uint32_t k = 0; k < s.sets; ++k) {
        stop_if_interrupted();
        const PointSet set = sampler->sample(k);
        const std::vector<double> l2 = l2_star_discrepancies(set, counts);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double star = star_discrepancy(set, counts[i]);
            found.l2[i] += l2[i] * l2[i] / s.sets;
            found.star[i] += star * star / s.sets;
        }
        squares += std::pow(l2.back(), 4) / s.sets;
    }
    const double mean = found.l2.back();
    for (auto* values : {&found.l2, &found.star})
        for (double& value : *values) value = std::sqrt(value);
    found.l2_error = std::sqrt(std::max(0.0, squares - mean * mean) / (s.sets - 1)) / (2 * found.l2.back());
    return found;
}

CurveChart chart_of(const std::vector<MethodDiscrepancies>& all, const std::vector<std::size_t>& counts, bool of_star)
{
    const double first = std::log2(fewest);
    const double last = std::max(first + 1, std::ceil(std::log2(static_cast<double>(counts.back()))));
    std::vector<ChartCurve> curves;
    double lowest = -1;
    for (const MethodDiscrepancies& method : all) {
        ChartCurve curve{method.title, class_color(curves.size()), {}};
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const double height = std::log10(of_star ? method.star[i] : method.l2[i]);
            curve.places.push_back({std::log2(static_cast<double>(counts[i])), height});
            lowest = std::min(lowest, std::floor(height));
        }
        curves.push_back(std::move(curve));
    }
    return {{"binary logarithm of the number of points", first, last, 1},
            {"decimal logarithm", lowest, 0, 1},
            lowest,
            std::move(curves)};
}

DistributionTable table_of(const std::vector<MethodDiscrepancies>& all, const std::vector<std::size_t>& counts,
                           bool of_star)
{
    DistributionTable table{of_star ? "Number of points times the star discrepancy"
                                    : "Number of points times the L2 star discrepancy",
                            {"points"},
                            {}};
    for (const MethodDiscrepancies& method : all) table.columns.push_back(method.title);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (i % static_cast<std::size_t>(counts_per_doubling) != 0 && i + 1 < counts.size()) continue;
        table.rows.push_back({fmt::format("{}", counts[i])});
        for (const MethodDiscrepancies& method : all)
            table.rows.back().push_back(
                fmt::format("{:.2f}", static_cast<double>(counts[i]) * (of_star ? method.star[i] : method.l2[i])));
    }
    return table;
}

DistributionResult make_discrepancies(const DiscrepancySettings& s, std::uint64_t seed, const DistributionPlace& place,
                                      DistributionFiles& files)
{
    const std::vector<std::size_t> counts = counts_up_to(s.points);
    std::vector<MethodDiscrepancies> all;
    DistributionResult result;
    for (const std::string& method : s.methods) {
        all.push_back(measured(method, s, counts, seed, place));
        const MethodDiscrepancies& found = all.back();
        result.numbers.push_back({"l2_star_" + method, found.title, found.l2.back(),
                                  fmt::format("L2 star discrepancy of {} points", s.points), found.l2_error});
        if (counts.size() > 1)
            result.numbers.push_back({"exponent_" + method, found.title + ", exponent",
                                      MethodDiscrepancies::exponent(counts, found.l2),
                                      "of the number of points, in a power law of the L2 star discrepancy"});
    }
    result.facts = {fmt::format("first {} to {} points of {} sets of each method", counts.front(), s.points, s.sets),
                    "root mean squares over sets"};
    for (const bool of_star : {false, true}) {
        files.add_curves(of_star ? "star" : "l2-star", chart_of(all, counts, of_star),
                         of_star ? "Star discrepancy of the first points of sets: the largest difference between the "
                                   "part of the points in a box at the origin and the box's area."
                                 : "L2 star discrepancy of the first points of sets: the root of the mean square, over "
                                   "all boxes at the origin, of the difference between the part of the points in a "
                                   "box and the box's area.",
                         result);
        result.tables.push_back(table_of(all, counts, of_star));
    }
    return result;
}

}

Kind discrepancy_kind()
{
    return make_kind<DiscrepancySettings>(
        {"distribution", "discrepancy", "", "Discrepancy", "Measure the discrepancy of the first points of sets"},
        discrepancy_keys, [](const DiscrepancySettings&) { return std::string("Discrepancy of first points"); },
        make_discrepancies);
}

}
