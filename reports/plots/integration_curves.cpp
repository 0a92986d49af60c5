#include "reports/plots/integration_curves.hpp"

#include "reports/plots/plot_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {

namespace {

struct Extent
{
    double low = 0;
    double high = 0;

    void add(double value)
    {
        low = low > 0 ? std::min(low, value) : value;
        high = std::max(high, value);
    }
};

std::string data_block(const IntegrationCurve& curve)
{
    std::string block = fmt::format("$errors{} << END\n", curve.index);
    for (const auto& sample : curve.samples)
        if (sample.rms_error > 0)
            fmt::format_to(std::back_inserter(block), "{} {:.6g} {:.6g}\n", sample.points, sample.rms_error,
                           sample.standard_error);
    return block + "END\n";
}

std::string logarithmic_axes(const Extent& points, const Extent& errors)
{
    const double bottom = std::pow(10, std::floor(std::log10(errors.low)));
    const double top = std::pow(10, std::ceil(std::log10(errors.high)));
    return axes("number of points N", points.low, points.high, {"RMS error of the integral", bottom, top, 10, 0}) +
           "set logscale xy\nset xtics 4\nset format y '10^{%L}'\nset lmargin 9\nset rmargin 4\n";
}

// Slope -1/2 from the upper left: how errors of random points fall.
std::string monte_carlo_guide(const Extent& points, const Extent& errors)
{
    return fmt::format("set arrow from {0:.6g}, {1:.6g} to {2:.6g}, {3:.6g} nohead back lw 0.8 dt (6,4) lc rgb '{4}'\n"
                       "set label 'N^{{−1/2}}' at {2:.6g}, {3:.6g} right offset 0,0.8 textcolor rgb '{4}'\n",
                       points.low, errors.high, points.high, errors.high * std::sqrt(points.low / points.high),
                       mark_color);
}

}

std::vector<std::string> integrands_of(const std::vector<IntegrationCurve>& curves)
{
    std::vector<std::string> names;
    for (const auto& curve : curves)
        if (std::ranges::find(names, curve.integrand) == names.end()) names.push_back(curve.integrand);
    return names;
}

GnuplotPicture plot_integration_error(const std::vector<IntegrationCurve>& curves, const std::string& integrand,
                                      const std::filesystem::path& stem)
{
    Extent points, errors;
    std::string data;
    std::string plot;
    std::vector<KeyEntry> key;
    for (const auto& curve : curves) {
        if (curve.integrand != integrand) continue;
        for (const auto& sample : curve.samples) {
            points.add(sample.points);
            if (sample.rms_error > 0) errors.add(sample.rms_error);
        }
        data += data_block(curve);
        plot +=
            fmt::format("{0}$errors{1} using 1:2 with lines {2} notitle, $errors{1} using 1:2 with points pt 7 "
                        "ps 0.3 lc rgb '{3}' notitle, $errors{1} using 1:($2-$3):(0):(2*$3) with vectors nohead "
                        "lw 2.5 lc rgb '{3}' notitle",
                        plot.empty() ? "plot " : ", ", curve.index, line_style(curve.index), curve_color(curve.index));
        key.push_back({curve.index, curve.label});
    }
    if (!(errors.low > 0)) errors = {1, 1};
    return with_key(logarithmic_axes(points, errors) + monte_carlo_guide(points, errors) + data, plot, key, stem);
}

}
