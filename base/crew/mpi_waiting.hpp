// Waiting for MPI without keeping a core busy, as MPI's own calls would: other processes may have work for it.
#pragma once

#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace poissonlab {

/// The longest pause between two looks for messages: looking takes some microseconds, and jobs take tens of
/// milliseconds.
inline constexpr std::chrono::microseconds longest_pause{1000};

/// Waits until a request is done. What comes soon is not kept waiting.
inline void wait_for(MPI_Request& request)
{
    std::chrono::microseconds pause{10};
    for (int is_done = 0;;) {
        MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
        if (is_done) return;
        std::this_thread::sleep_for(pause);
        pause = std::min(2 * pause, longest_pause);
    }
}

}
