// Listeners that are told of work while it goes on.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace poissonlab {

/// Hears of the progress of one job. Functions may be empty.
struct WorkListener
{
    /// A realization was made, of so many points, in so many seconds.
    std::function<void(std::size_t points, double seconds)> sampled;
    /// A realization was analysed, or its stored analysis was taken.
    std::function<void()> analysed;
};

}
