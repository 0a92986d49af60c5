// A quantity over the realizations of a series.
#pragma once

#include <optional>
#include <vector>

namespace poissonlab {

struct Statistic
{
    double min = 0;
    double mean = 0;
    double max = 0;
    std::vector<double> each; ///< of every realization; empty: not stored

    bool operator==(const Statistic&) const = default;
};

/// The statistic of the values of all realizations, none where one has no value: a single point has no distance.
std::optional<Statistic> statistic_of(const std::vector<double>& each);

/// The median; the mean of the middle two for an even number of values. `values` must not be empty.
double median(std::vector<double> values);

}
