// The curves of the error of integrals over the number of points, for methods whose sets come in several
// sizes.
#pragma once

#include "reports/plots/plot.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// The error of one integrand, with sets of N points.
struct IntegrationSample
{
    double points = 0;
    double rms_error = 0;
    double standard_error = 0;
};

/// One method with one integrand.
struct IntegrationCurve
{
    std::size_t index = 0; ///< number of the method among those with curves, for the colour
    std::string label;     ///< without numbers of points
    std::string integrand;
    std::vector<IntegrationSample> samples; ///< N grows
};

/// The integrands of the curves, each once, in their order.
std::vector<std::string> integrands_of(const std::vector<IntegrationCurve>& curves);

/// All curves of an integrand in one plot with logarithmic axes and bars of one standard error. Errors of 0 are left
/// out.
Plot integration_error_plot(const std::vector<IntegrationCurve>& curves, const std::string& integrand);

}
