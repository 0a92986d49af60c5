#include "reports/gallery/sizes.hpp"

#include "reports/gallery/table_reader.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// Shorter times are those of starting work.
constexpr double least_seconds = 0.01;

std::vector<SizedMethod> read_sizes(std::string_view table)
{
    std::vector<SizedMethod> methods;
    for (TableReader line(table, "sizes.csv", "sampler,keys,dimension,points,seconds,gigabytes"); line.next();) {
        const int dimension = static_cast<int>(line.number(2));
        if (methods.empty() || methods.back().sampler != line.text(0) || methods.back().keys != line.text(1) ||
            methods.back().dimension != dimension)
            methods.push_back({line.text(0), line.text(1), dimension, {}});
        methods.back().costs.push_back({static_cast<std::size_t>(line.number(3)), line.number(4), line.number(5)});
    }
    return methods;
}

std::string size_row(const SizedMethod& method)
{
    std::string row = fmt::format("| `{}`{} | {}D |", method.sampler,
                                  method.keys.empty() ? "" : ", `" + method.keys + "`", method.dimension);
    for (const std::size_t points : {10'000, 100'000, 1'000'000, 10'000'000}) {
        const auto cost = std::ranges::find(method.costs, points, &SizeCost::points);
        row +=
            cost == method.costs.end() ? " |" : fmt::format(" {:.3g} s, {:.2g} GB |", cost->seconds, cost->gigabytes);
    }
    const double exponent = method.exponent();
    return row + (std::isnan(exponent) ? " |\n" : fmt::format(" {:.2f} |\n", exponent));
}

}

double SizedMethod::exponent() const
{
    if (costs.size() < 2 || costs[costs.size() - 2].seconds < least_seconds)
        return std::numeric_limits<double>::quiet_NaN();
    const SizeCost &last = costs.back(), &before = costs[costs.size() - 2];
    return std::log(last.seconds / before.seconds) /
           std::log(static_cast<double>(last.points) / static_cast<double>(before.points));
}

const std::vector<SizedMethod>& measured_sizes()
{
    static const std::vector<SizedMethod> sizes = read_sizes(gallery_file("sizes.csv"));
    return sizes;
}

std::string size_table(const std::string& sampler)
{
    std::string rows;
    for (const SizedMethod& method : measured_sizes())
        if (sampler.empty() || method.sampler == sampler) rows += size_row(method);
    if (rows.empty()) return "";
    return "| method | dimension | 10^4 points | 10^5 | 10^6 | 10^7 | exponent |\n| --- | --- | --- | --- | --- | --- "
           "| --- "
           "|\n" +
           rows;
}

}
