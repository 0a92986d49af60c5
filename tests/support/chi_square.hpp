// Pearson's chi-square test of counts, with correction for the number of tests.
#pragma once

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace poissonlab::test {

/// sum (count - expected)^2 / expected, with the same expectation for all cells.
inline double chi_square(std::span<const std::uint64_t> counts)
{
    double total = 0;
    for (const std::uint64_t count : counts) total += static_cast<double>(count);
    const double expected = total / static_cast<double>(counts.size());
    double sum = 0;
    for (const std::uint64_t count : counts) {
        const double difference = static_cast<double>(count) - expected;
        sum += difference * difference / expected;
    }
    return sum;
}

/// The probability that chi-square with so many degrees of freedom is larger.
inline double chi_square_tail(double statistic, double degrees)
{
    return statistic <= 0 ? 1 : boost::math::gamma_q(degrees / 2, statistic / 2);
}

/// True if counts are what chance makes of equal probabilities: neither too far off nor too even. Chance
/// fails one of `comparisons` such tests once in 10,000 runs (Sidak's correction). `excess`: by how much
/// known, small differences of the probabilities raise the expectation of the statistic.
inline bool are_equally_likely(std::span<const std::uint64_t> counts, std::size_t comparisons, double excess = 0)
{
    const double p = -std::expm1(std::log1p(-1e-4) / static_cast<double>(2 * comparisons));
    const double degrees = static_cast<double>(counts.size() - 1);
    const double statistic = chi_square(counts);
    return chi_square_tail(statistic - excess, degrees) > p && 1 - chi_square_tail(statistic, degrees) > p;
}

}
