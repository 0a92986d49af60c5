#include "host/texture/endless/normal_distribution.hpp"

namespace poissonlab {
namespace {

/// exp(-v) for v from 0 to 32, by its series of a 64th part, squared six times.
double exponential_decay(double v)
{
    const double part = -v / 64;
    double term = 1, sum = 1;
    for (int n = 1; n <= 20; ++n) {
        term *= part / n;
        sum += term;
    }
    for (int i = 0; i < 6; ++i) sum *= sum;
    return sum;
}

constexpr double root_of_two_pi = 2.5066282746310005024;

/// The probability of more than x deviations, for x of 3 and more: Laplace's continued fraction.
double upper_tail(double x)
{
    double fraction = x;
    for (int k = 120; k >= 1; --k) fraction = x + k / fraction;
    return exponential_decay(x * x / 2) / root_of_two_pi / fraction;
}

}

double normal_probability(double deviations)
{
    const double x = deviations < 0 ? -deviations : deviations;
    if (x >= 3) return deviations < 0 ? upper_tail(x) : 1 - upper_tail(x);
    // Phi(x) = 1/2 + phi(x) (x + x^3 / 3 + x^5 / (3 5) + ...)
    double term = x, sum = x;
    for (int n = 1; n <= 80; ++n) {
        term *= x * x / (2 * n + 1);
        sum += term;
    }
    const double half = exponential_decay(x * x / 2) / root_of_two_pi * sum;
    return deviations < 0 ? 0.5 - half : 0.5 + half;
}

}
