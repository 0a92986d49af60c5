#include "analysis/statistics/jackknife.hpp"

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

}
