#include "analysis/statistics/jackknife.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <stdexcept>

namespace poissonlab {
namespace {

/// The squared deviations of the values from their mean, summed up.
double squared_deviations(const std::vector<double>& values)
{
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double sum = 0;
    for (const double value : values) sum += (value - mean) * (value - mean);
    return sum;
}

/// Curves of one size, and their sum.
class LeaveOut
{
public:
    explicit LeaveOut(const std::vector<std::vector<double>>& curves) : curves_(curves)
    {
        if (curves.size() < 2) throw std::invalid_argument("jackknife_error: one curve alone has no error");
        sum_.resize(curves.front().size());
        for (const auto& curve : curves) {
            if (curve.size() != sum_.size()) throw std::invalid_argument("jackknife_error: curves differ in size");
            for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += curve[i];
        }
        mean_.resize(sum_.size());
    }

    /// The mean of all curves but these, which must leave one at least.
    const std::vector<double>& mean_without(std::initializer_list<std::size_t> left_out)
    {
        mean_ = sum_;
        for (const std::size_t k : left_out)
            for (std::size_t i = 0; i < mean_.size(); ++i) mean_[i] -= curves_[k][i];
        for (double& value : mean_) value /= static_cast<double>(curves_.size() - left_out.size());
        return mean_;
    }

private:
    const std::vector<std::vector<double>>& curves_;
    std::vector<double> sum_, mean_;
};

/// The jackknife's variance from the statistics without each of the curves.
double jackknife_variance(const std::vector<double>& without)
{
    const auto n = static_cast<double>(without.size());
    return squared_deviations(without) * (n - 1) / n;
}

}

double jackknife_error(const std::vector<std::vector<double>>& curves,
                       const std::function<double(const std::vector<double>& mean)>& statistic)
{
    LeaveOut means(curves);
    std::vector<double> without;
    for (std::size_t k = 0; k < curves.size(); ++k) without.push_back(statistic(means.mean_without({k})));
    return std::sqrt(jackknife_variance(without));
}

double jackknife_error_of_squares(const std::vector<std::vector<double>>& all,
                                  const std::function<double(const std::vector<double>& mean)>& statistic)
{
    constexpr std::size_t most = 32;
    std::vector<std::size_t> groups;
    for (std::size_t k = 0; k < all.size(); ++k) groups.push_back(k % most);
    const auto curves = all.size() > most ? group_means(all, groups) : all;
    if (curves.size() < 3) return jackknife_error(curves, statistic);
    LeaveOut means(curves);
    const auto n = static_cast<double>(curves.size());
    const double whole = statistic(means.mean_without({}));
    std::vector<double> without, interactions;
    for (std::size_t k = 0; k < curves.size(); ++k) without.push_back(statistic(means.mean_without({k})));
    for (std::size_t k = 0; k < curves.size(); ++k)
        for (std::size_t j = 0; j < k; ++j)
            interactions.push_back(n * whole - (n - 1) * (without[j] + without[k]) +
                                   (n - 2) * statistic(means.mean_without({j, k})));
    const double variance = jackknife_variance(without);
    const double too_much = squared_deviations(interactions) / (n * (n - 1));
    return std::sqrt(std::max(variance / 2, variance - too_much)); // half of it is the least that is true
}

double standard_error_of_mean(const std::vector<double>& values)
{
    if (values.size() < 2) throw std::invalid_argument("standard_error_of_mean: one value alone has no error");
    const auto count = static_cast<double>(values.size());
    return std::sqrt(squared_deviations(values) / (count - 1) / count);
}

std::vector<std::vector<double>> group_means(const std::vector<std::vector<double>>& curves,
                                             const std::vector<std::size_t>& groups)
{
    if (groups.empty()) return curves;
    if (groups.size() != curves.size()) throw std::invalid_argument("group_means: each curve must have a group");
    std::vector<std::size_t> names; // in the order of `means`
    std::vector<std::vector<double>> means;
    std::vector<double> members;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const auto at = static_cast<std::size_t>(std::ranges::find(names, groups[k]) - names.begin());
        if (at == names.size()) {
            names.push_back(groups[k]);
            means.emplace_back(curves.front().size());
            members.push_back(0);
        }
        if (curves[k].size() != means[at].size()) throw std::invalid_argument("group_means: curves differ in size");
        for (std::size_t i = 0; i < means[at].size(); ++i) means[at][i] += curves[k][i];
        ++members[at];
    }
    for (std::size_t group = 0; group < means.size(); ++group)
        for (double& value : means[group]) value /= members[group];
    return means;
}

std::vector<double> errors_of_mean(const std::vector<std::vector<double>>& all, const std::vector<std::size_t>& groups)
{
    const auto curves = group_means(all, groups);
    if (curves.size() < 2) return {};
    std::vector<double> errors, values;
    for (std::size_t i = 0; i < curves.front().size(); ++i) {
        values.clear();
        for (const auto& curve : curves) values.push_back(curve[i]);
        errors.push_back(standard_error_of_mean(values));
    }
    return errors;
}

std::vector<double> group_means(const std::vector<double>& values, const std::vector<std::size_t>& groups)
{
    std::vector<std::vector<double>> curves;
    for (const double value : values) curves.push_back({value});
    std::vector<double> means;
    for (const auto& mean : group_means(curves, groups)) means.push_back(mean.front());
    return means;
}

}
