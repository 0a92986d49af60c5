// The number of threads that the host uses.
#pragma once

#include <tbb/global_control.h>

#include <optional>

namespace poissonlab {

/// Limits oneTBB, and with it sampling and analysis on the host, for as long as it lives. 0: no limit.
class ThreadLimit
{
public:
    explicit ThreadLimit(int threads)
    {
        if (threads > 0)
            control_.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    }

    static int current()
    {
        return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    }

private:
    std::optional<tbb::global_control> control_;
};

}
