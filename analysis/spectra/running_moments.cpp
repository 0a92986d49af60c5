#include "analysis/spectra/running_moments.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace poissonlab {

void RunningMoments::add(std::span<const double> values)
{
    ++count_;
    if (count_ == 1) mean_.resize(values.size());
    if (count_ == 2) squares_.resize(values.size());
    const double share = 1.0 / count_;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mean_.size(), 65536), [&](const auto& range) {
        if (count_ == 1) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) mean_[i] = values[i];
            return;
        }
        if (count_ == 2) std::fill_n(squares_.begin() + range.begin(), range.size(), 0.0);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const double difference = values[i] - mean_[i];
            mean_[i] += difference * share;
            squares_[i] += difference * (values[i] - mean_[i]);
        }
    });
}

void RunningMoments::append(const RunningMoments& other)
{
    if (other.count_ == 0) return;
    if (count_ == 0) {
        *this = other;
        return;
    }
    const bool had_squares = count_ > 1;
    const double all = count_ + other.count_;
    const double share = other.count_ / all;
    const double weight = count_ * share;
    count_ += other.count_;
    if (!had_squares) squares_.resize(mean_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mean_.size(), 65536), [&](const auto& range) {
        if (!had_squares) std::fill_n(squares_.begin() + range.begin(), range.size(), 0.0);
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const double difference = other.mean_[i] - mean_[i];
            mean_[i] += difference * share;
            squares_[i] += difference * difference * weight;
            if (other.count_ > 1) squares_[i] += other.squares_[i];
        }
    });
}

}
