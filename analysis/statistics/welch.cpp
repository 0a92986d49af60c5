#include "analysis/statistics/welch.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace poissonlab {

SampleMean sample_mean(std::span<const double> values)
{
    const auto n = static_cast<double>(values.size());
    // About the first value, so that equal values have a spread of exactly 0.
    const double origin = values.front();
    double sum = 0;
    for (const double v : values) sum += v - origin;
    const double shift = sum / n;
    double squares = 0;
    for (const double v : values) squares += (v - origin - shift) * (v - origin - shift);
    const double error = values.size() > 1 ? std::sqrt(squares / (n - 1) / n) : 0;
    return {origin + shift, error, values.size()};
}

WelchTest welch_test(const SampleMean& first, const SampleMean& second)
{
    if (first.samples < 2 || second.samples < 2) throw std::invalid_argument("Welch's test needs two samples of each");
    const double a = first.standard_error * first.standard_error;
    const double b = second.standard_error * second.standard_error;
    if (!(a + b > 0)) throw std::invalid_argument("Welch's test needs a spread");

    WelchTest test;
    test.t = (second.value - first.value) / std::sqrt(a + b);
    // Welch and Satterthwaite, in shares of the variance: squares of small errors must not underflow.
    const double share = a / (a + b);
    test.degrees_of_freedom = 1 / (share * share / static_cast<double>(first.samples - 1) +
                                   (1 - share) * (1 - share) / static_cast<double>(second.samples - 1));
    const boost::math::students_t distribution(test.degrees_of_freedom);
    test.p_value = std::min(1.0, 2 * boost::math::cdf(boost::math::complement(distribution, std::abs(test.t))));
    return test;
}

std::vector<double> holm_adjusted(std::span<const double> p_values)
{
    std::vector<std::size_t> order(p_values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p_values[i]; });
    std::vector<double> adjusted(p_values.size());
    double largest = 0;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const double p = p_values[order[rank]] * static_cast<double>(order.size() - rank);
        largest = std::max(largest, std::min(1.0, p));
        adjusted[order[rank]] = largest;
    }
    return adjusted;
}

}
