#include "analysis/running_moments.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstddef>

namespace poissonlab {

void RunningMoments::add(const std::vector<double>& values)
{
    if (++count_ == 1) {
        mean_ = values;
        return;
    }
    if (count_ == 2) squares_.resize(mean_.size());
    const double share = 1.0 / count_;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mean_.size(), 65536), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const double difference = values[i] - mean_[i];
            mean_[i] += difference * share;
            squares_[i] += difference * (values[i] - mean_[i]);
        }
    });
}

std::vector<double> RunningMoments::variance() const
{
    std::vector<double> result = squares_;
    for (double& value : result) value /= count_ - 1;
    return result;
}

}
