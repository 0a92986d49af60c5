#include "analysis/statistics/jackknife.hpp"

#include <algorithm>
#include <cmath>
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

}

double jackknife_error(const std::vector<std::vector<double>>& curves,
                       const std::function<double(const std::vector<double>& mean)>& statistic)
{
    if (curves.size() < 2) throw std::invalid_argument("jackknife_error: one curve alone has no error");
    std::vector<double> sum(curves.front().size());
    for (const auto& curve : curves) {
        if (curve.size() != sum.size()) throw std::invalid_argument("jackknife_error: curves differ in size");
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += curve[i];
    }
    const auto others = static_cast<double>(curves.size() - 1);
    std::vector<double> without, mean(sum.size());
    for (const auto& curve : curves) {
        for (std::size_t i = 0; i < sum.size(); ++i) mean[i] = (sum[i] - curve[i]) / others;
        without.push_back(statistic(mean));
    }
    return std::sqrt(squared_deviations(without) * others / (others + 1));
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

std::vector<double> group_means(const std::vector<double>& values, const std::vector<std::size_t>& groups)
{
    std::vector<std::vector<double>> curves;
    for (const double value : values) curves.push_back({value});
    std::vector<double> means;
    for (const auto& mean : group_means(curves, groups)) means.push_back(mean.front());
    return means;
}

}
