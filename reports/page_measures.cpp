// The measures of one series, each with what it means.
#include "reports/number_format.hpp"
#include "reports/page_parts.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

PageData measure(const char* name, const std::string& value, const std::string& meaning)
{
    PageData data;
    data.set("name", name);
    data.set("value", value);
    data.set("meaning", meaning);
    return data;
}

// "disk 0.051, step 0.12"
std::string integrals_text(const std::vector<StoredMeasures::Integral>& integrals)
{
    std::string text;
    for (const auto& integral : integrals)
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", integral.integrand,
                            format_significant(integral.relative_variance, 2));
    return text;
}

std::string with_error(double value, double error)
{
    return fmt::format("{} ± {}", format_fixed(value, 3), format_fixed(error, 3));
}

}

PageData measures_list(const StoredMeasures& measures)
{
    PageData list{PageData::type::list};
    if (measures.effective_nyquist)
        list << measure("Effective Nyquist frequency", format_fixed(*measures.effective_nyquist, 3),
                        "up to where the mean power stays below 0.1, in units of √N / 2 (3D: ∛N / 2): higher is better");
    if (measures.oscillation)
        list << measure("Oscillation",
                        fmt::format("{} (noise alone {})", format_fixed(measures.oscillation->value, 2),
                                    format_fixed(measures.oscillation->noise_floor, 2)),
                        "how much the power goes up and down beyond its rise: lower is better");
    if (const auto& fit = measures.low_frequency_power) {
        list << measure("Low-frequency exponent", with_error(fit->exponent, fit->exponent_error),
                        "b in power ~ frequency^b: 0 for random points, above 0 errors of integrals fall faster");
        list << measure("Power towards frequency 0", with_error(fit->intercept, fit->intercept_error),
                        "1 for random points, 0.059 for saturated dart throwing: lower is better");
    }
    if (const auto& peaks = measures.lattice_peaks)
        list << measure("Lattice peaks",
                        fmt::format("{} at most, {} on average", format_significant(peaks->max_ratio, 3),
                                    format_significant(peaks->mean_ratio, 3)),
                        fmt::format("power at multiples of frequency {} over that around them, {} places: 1 on average "
                                    "without tiles",
                                    peaks->tiles, format_count(static_cast<std::uint64_t>(peaks->peaks))));
    if (!measures.integration.empty())
        list << measure("Error of integrals", integrals_text(measures.integration),
                        "mean squared error over that of as many random points: lower is better");
    if (measures.largest_empty_radius)
        list << measure("Largest gap", format_fixed(*measures.largest_empty_radius, 3),
                        "radius of the largest empty circle over the largest possible minimum distance: at least 0.577 "
                        "in 2D; a gap above the relative radius has room for another point");
    if (const auto& cells = measures.voronoi) {
        const auto& share = cells->neighbour_share;
        list << measure("Voronoi cells with 5, 6, 7 neighbours",
                        fmt::format("{} %, {} %, {} %", format_fixed(100 * share[1], 1), format_fixed(100 * share[2], 1),
                                    format_fixed(100 * share[3], 1)),
                        "100 % with 6 is a hexagonal lattice");
        list << measure("Variance of Voronoi areas", format_fixed(cells->relative_area_variance, 4),
                        "over their squared mean: 0.280 for random points");
    }
    return list;
}

}
