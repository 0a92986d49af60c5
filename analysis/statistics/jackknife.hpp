// Standard errors of what is computed from an average over realizations: leave one out, see how much that changes.
//
// Tukey, Bias and confidence in not quite large samples, Annals of Mathematical Statistics 29, 1958; Efron and Stein,
// The jackknife estimate of variance, Annals of Statistics 9(3), 1981: right for quantities that are linear in the
// average, too large on average for others, up to twice the variance for squares of a mean that is 0 otherwise.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace poissonlab {

/// The standard error of statistic(mean of the curves). Takes at least two curves of one size; throws
/// std::invalid_argument otherwise.
double jackknife_error(const std::vector<std::vector<double>>& curves,
                       const std::function<double(const std::vector<double>& mean)>& statistic);

/// The standard error of the mean of independent values, at least two; the same for the statistic that is the mean.
double standard_error_of_mean(const std::vector<double>& values);

/// The mean curve of each group, in the order in which groups come first: curve k belongs to group groups[k].
/// Realizations that share something, such as a tile set, are not independent, their groups are. Takes curves of one
/// size and a group for each; throws std::invalid_argument otherwise.
std::vector<std::vector<double>> group_means(const std::vector<std::vector<double>>& curves,
                                             const std::vector<std::size_t>& groups);

/// The same of values.
std::vector<double> group_means(const std::vector<double>& values, const std::vector<std::size_t>& groups);

}
