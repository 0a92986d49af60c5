#include "base/geometry/circle_point.hpp"

#include <numbers>

namespace poissonlab {
namespace {

/// Cosine and sine of `part` turns, 0 to 1/8, by their series: libraries differ in last bits, results must not.
std::array<double, 2> short_circle(double part)
{
    const double x = 2 * std::numbers::pi * part, squared = x * x;
    double cosine = 0, sine = 0;
    for (int n = 18; n >= 2; n -= 2) {
        cosine = (1 - cosine) * squared / (n * (n - 1));
        sine = (1 - sine) * squared / (n * (n + 1));
    }
    return {1 - cosine, x * (1 - sine)};
}

}

std::array<double, 2> circle_point(double part)
{
    if (part > 0.5) {
        const auto [cosine, sine] = circle_point(1 - part);
        return {cosine, -sine};
    }
    if (part > 0.25) {
        const auto [cosine, sine] = circle_point(0.5 - part);
        return {-cosine, sine};
    }
    if (part <= 0.125) return short_circle(part);
    const auto [cosine, sine] = short_circle(0.25 - part);
    return {sine, cosine};
}

}
