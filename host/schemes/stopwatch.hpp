// Times of small pieces of work that are compared with each other.
#pragma once

#include "base/programs/interrupt.hpp"
#include "results/statistic.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

namespace poissonlab {

/// The median time of each piece of work in nanoseconds over `steps`. Pieces take turns, so that what disturbs the
/// machine disturbs all of them. Throws Interrupted.
inline std::vector<double> median_nanoseconds(const std::vector<std::function<void()>>& pieces, double steps)
{
    constexpr int rounds = 7;
    std::vector<std::vector<double>> times(pieces.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            stop_if_interrupted();
            const auto begin = std::chrono::steady_clock::now();
            pieces[i]();
            const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begin;
            times[i].push_back(taken.count() / steps);
        }
    std::vector<double> medians;
    for (std::vector<double>& all : times) medians.push_back(median(std::move(all)));
    return medians;
}

}
