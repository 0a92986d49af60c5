// Mean and variance of many values at once, one observation of all of them after the other.
#pragma once

#include <vector>

namespace poissonlab {

/// Welford: Note on a Method for Calculating Corrected Sums of Squares and Products, Technometrics 4(3), 1962: no
/// cancellation, one pass.
class RunningMoments
{
public:
    /// As many values each time.
    void add(const std::vector<double>& values);

    int count() const { return count_; }
    const std::vector<double>& mean() const { return mean_; }

    /// Divisor count - 1; at least two observations.
    std::vector<double> variance() const;

private:
    int count_ = 0;
    std::vector<double> mean_, squares_; ///< squared deviations from the mean, summed up; empty for one observation
};

}
