// Work of the laboratory on behalf of the interpreter: without its lock, one at a time, until Ctrl-C.
#pragma once

#include "base/programs/interrupt.hpp"
#include "base/programs/interrupt_scope.hpp"

#include <cblas.h>
#include <pybind11/pybind11.h>

#include <mutex>
#include <type_traits>
#include <utility>

namespace poissonlab {

/// Held by the thread that works: devices and Ctrl-C are shared by all.
inline std::mutex& turn_of_work()
{
    static std::mutex turn;
    return turn;
}

/// Gives OpenBLAS, which exact periodograms set to one thread, the threads back that NumPy has there.
class BlasThreads
{
public:
    BlasThreads() : before_(openblas_get_num_threads()) {}
    ~BlasThreads() { openblas_set_num_threads(before_); }
    BlasThreads(const BlasThreads&) = delete;
    BlasThreads& operator=(const BlasThreads&) = delete;

private:
    int before_;
};

/// Does work that touches no Python object. Other threads of the interpreter run meanwhile; work of several of them
/// takes turns, as devices and Ctrl-C are shared. Throws Interrupted, which becomes KeyboardInterrupt, and what the
/// work throws.
template <typename Work>
auto without_lock(Work&& work)
{
    const pybind11::gil_scoped_release unlocked;
    const std::lock_guard turn(turn_of_work());
    const InterruptScope interrupts;
    const BlasThreads threads_of_numpy;
    if constexpr (std::is_void_v<decltype(work())>) {
        std::forward<Work>(work)();
        stop_if_interrupted();
    } else {
        auto result = std::forward<Work>(work)();
        stop_if_interrupted();
        return result;
    }
}

}
