#include "reports/plots/integration_curves.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

struct ValueRange
{
    double low = 0;
    double high = 0;

    void add(double value)
    {
        low = low > 0 ? std::min(low, value) : value;
        high = std::max(high, value);
    }
};

}

std::vector<std::string> integrands_of(const std::vector<IntegrationCurve>& curves)
{
    std::vector<std::string> names;
    for (const auto& curve : curves)
        if (std::ranges::find(names, curve.integrand) == names.end()) names.push_back(curve.integrand);
    return names;
}

Plot integration_error_plot(const std::vector<IntegrationCurve>& curves, const std::string& integrand)
{
    Plot plot;
    ValueRange points, errors;
    for (const auto& source : curves) {
        if (source.integrand != integrand) continue;
        PlotCurve curve{source.index, source.label};
        curve.has_bars = true;
        for (const auto& sample : source.samples) {
            points.add(sample.points);
            curve.end = std::max(curve.end, sample.points);
            if (!(sample.rms_error > 0)) continue;
            errors.add(sample.rms_error);
            curve.x.push_back(sample.points);
            curve.y.push_back(sample.rms_error);
            curve.low.push_back(sample.rms_error - sample.standard_error);
            curve.high.push_back(sample.rms_error + sample.standard_error);
        }
        curve.dots = curve.y;
        plot.curves.push_back(std::move(curve));
    }
    if (!(errors.low > 0)) errors = {1, 1};
    plot.x = {.label = "number of points N", .low = points.low, .step = 4, .logarithmic = true};
    plot.y = {.label = "RMS error of the integral",
              .low = std::pow(10, std::floor(std::log10(errors.low))),
              .high = std::pow(10, std::ceil(std::log10(errors.high))),
              .step = 10,
              .logarithmic = true};
    // Errors of random points fall with slope -1/2, here from the upper left.
    plot.slopes = {
        {points.low, errors.high, points.high, errors.high * std::sqrt(points.low / points.high), "N^{−1/2}"}};
    plot.left_margin = 9;
    plot.right_margin = 4;
    return together(std::move(plot));
}

}
