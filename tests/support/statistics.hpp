// The tools of stochastic tests: means with their standard errors, and how far a deviation may go.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace poissonlab::test {

struct Mean
{
    double value = 0;
    double standard_error = 0; ///< of the mean: sample standard deviation over sqrt(n)
};

inline Mean mean_of(const std::vector<double>& samples)
{
    const auto n = static_cast<double>(samples.size());
    double sum = 0;
    for (const double s : samples) sum += s;
    double squares = 0;
    for (const double s : samples) squares += (s - sum / n) * (s - sum / n);
    return {sum / n, std::sqrt(squares / (n - 1) / n)};
}

/// The difference of two means in units of its standard error.
inline double z_score(const Mean& a, const Mean& b)
{
    return (a.value - b.value) / std::hypot(a.standard_error, b.standard_error);
}

/// The two-sided bound for the largest of `comparisons` |z| scores that chance exceeds once in 10,000 test
/// runs (Sidak's correction): the z with 1 - (1 - p)^comparisons = 1e-4, p = erfc(z / sqrt 2).
inline double z_bound(std::size_t comparisons)
{
    const double p = -std::expm1(std::log1p(-1e-4) / static_cast<double>(comparisons));
    double low = 0;
    double high = 10;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > p ? low : high) = middle;
    }
    return high;
}

}
