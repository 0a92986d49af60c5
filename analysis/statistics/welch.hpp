// Tests of whether two means differ by more than chance: Welch's test, and Holm's correction for many tests.
//
// B. L. Welch, The generalization of "Student's" problem when several different population variances are involved,
// Biometrika 34, 1947; S. Holm, A simple sequentially rejective multiple test procedure, Scandinavian Journal of
// Statistics 6, 1979.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

/// The mean of independent values.
struct SampleMean
{
    double value = 0;
    double standard_error = 0; ///< sample standard deviation over sqrt(samples); 0 for a single one
    std::size_t samples = 1;
};

/// `values` must not be empty.
SampleMean sample_mean(std::span<const double> values);

struct WelchTest
{
    double t = 0; ///< the difference, second minus first, in units of its standard error
    double degrees_of_freedom = 0;
    double p_value = 1; ///< that chance makes |t| at least so large where the true means are equal
};

/// Welch's test of two means. Throws std::invalid_argument unless both are of at least two samples, and at least one
/// has a standard error above 0.
WelchTest welch_test(const SampleMean& first, const SampleMean& second);

/// p-values that may each be compared with one level: the probability that any true hypothesis falls below it is at
/// most that level, whatever the tests have to do with each other.
std::vector<double> holm_adjusted(std::span<const double> p_values);

}
