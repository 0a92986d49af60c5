// Standard errors of what is computed from an average over realizations: leave one out, see how much that changes.
//
// Tukey, Bias and confidence in not quite large samples, Annals of Mathematical Statistics 29, 1958; Efron and Stein,
// The jackknife estimate of variance, Annals of Statistics 9(3), 1981: right for quantities that are linear in the
// average, too large on average for others, up to twice the variance for squares of a mean that is 0 otherwise. What is
// too much in those is known from leaving out two (their section 5).
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace poissonlab {

/// The standard error of statistic(mean of the curves). Takes at least two curves of one size; throws
/// std::invalid_argument otherwise.
double jackknife_error(const std::vector<std::vector<double>>& curves,
                       const std::function<double(const std::vector<double>& mean)>& statistic);

/// The standard error of a statistic that is quadratic in the mean, so that noise itself adds to it: the jackknife of
/// second order takes away what jackknife_error() has too much of there. Takes at least three curves for that. Takes as
/// many evaluations as there are pairs of curves, of more than 32 those of 32 means of some of them.
double jackknife_error_of_squares(const std::vector<std::vector<double>>& curves,
                                  const std::function<double(const std::vector<double>& mean)>& statistic);

/// The standard error of the mean of independent values, at least two; the same for the statistic that is the mean.
double standard_error_of_mean(const std::vector<double>& values);

/// The mean curve of each group, in the order in which groups come first: curve k belongs to group groups[k].
/// Realizations that share something, such as a tile set, are not independent, their groups are. Without groups each
/// curve stands for itself. Takes curves of one size and a group for each; throws std::invalid_argument otherwise.
std::vector<std::vector<double>> group_means(const std::vector<std::vector<double>>& curves,
                                             const std::vector<std::size_t>& groups);

/// The standard error of each value of the mean of curves, of which those of one group are taken together; no groups:
/// each stands for itself. Empty where there is one group, or one curve.
std::vector<double> errors_of_mean(const std::vector<std::vector<double>>& curves,
                                   const std::vector<std::size_t>& groups = {});

/// The mean value of each group.
std::vector<double> group_means(const std::vector<double>& values, const std::vector<std::size_t>& groups);

}
