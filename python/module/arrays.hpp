// Arrays of NumPy made of the laboratory's values, and the other way round.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/interrupt_scope.hpp"

#include <cblas.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace poissonlab {

// Work of the laboratory on behalf of the interpreter: without its lock, one at a time, until Ctrl-C.

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

/// An array as callers may hand it over: of any type that becomes double, in any layout.
using AnyArray = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// An array that takes the values over, without a copy.
template <typename T>
pybind11::array_t<T> array_of(std::vector<T> values, std::vector<pybind11::ssize_t> shape);

/// An array with one axis that takes the values over, without a copy.
template <typename T>
pybind11::array_t<T> array_of(std::vector<T> values);

/// The member of every item, as an array with one axis.
template <typename T, typename Item, typename Member>
pybind11::array_t<T> column_of(const std::vector<Item>& items, Member Item::*member)
{
    std::vector<T> values;
    values.reserve(items.size());
    for (const Item& item : items) values.push_back(static_cast<T>(item.*member));
    return array_of(std::move(values));
}

/// The points as an array of shape (points, dimension).
pybind11::array_t<double> array_of(PointSet points);

/// The set of an array of shape (points, 2) or (points, 3) with coordinates in [0, 1), or any numbers where they are in
/// units of their own. `name` is how messages call it, and `words` how arguments that would fit are written. Throws
/// InputError.
PointSet point_set_of(const AnyArray& array, const std::string& name, bool has_own_units = false,
                      const PointOptions& words = {});

/// Messages about coordinates call the arguments so.
inline constexpr PointOptions argument_words{.domain = "domain=({}, {})",
                                             .region = "region=\"rectangle {} {} {} {}\"",
                                             .crs = "crs=\"EPSG:4326\"",
                                             .particles = "particles={}"};

template <typename T>
pybind11::array_t<T> array_of(std::vector<T> values, std::vector<pybind11::ssize_t> shape)
{
    auto kept = std::make_unique<std::vector<T>>(std::move(values));
    const pybind11::capsule owner(kept.get(), [](void* pointer) { delete static_cast<std::vector<T>*>(pointer); });
    return pybind11::array_t<T>(std::move(shape), kept.release()->data(), owner);
}

template <typename T>
pybind11::array_t<T> array_of(std::vector<T> values)
{
    const auto size = static_cast<pybind11::ssize_t>(values.size());
    return array_of(std::move(values), {size});
}

}
