// Mean and variance of many values at once, one observation of all of them after the other.
#pragma once

#include "analysis/spectra/uninitialized_vector.hpp"

#include <span>

namespace poissonlab {

/// Welford: Note on a Method for Calculating Corrected Sums of Squares and Products, Technometrics 4(3),
/// 1962: no cancellation, one pass.
class RunningMoments
{
public:
    /// Adds an observation of each value; every call has equally many.
    void add(std::span<const double> values);

    /// Appends the observations of `other`; equal to adding them here, up to rounding. Chan, Golub and LeVeque,
    /// Algorithms for Computing the Sample Variance, The American Statistician 37(3), 1983, equations 2.1.
    void append(const RunningMoments& other);

    int count() const { return count_; }
    std::span<const double> mean() const { return mean_; }

    /// Squared deviations from the mean, summed up: the variance times count - 1. Empty for one observation.
    std::span<const double> squares() const { return squares_; }

    /// All members as bytes.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(count_, mean_, squares_);
    }

private:
    int count_ = 0;
    UninitializedVector<double> mean_, squares_;
};

}
