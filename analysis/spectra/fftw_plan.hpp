// Plans of FFTW, whose planner serves one thread at a time: all plans are made and destroyed under one lock.
#pragma once

#include <fftw3.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>

namespace poissonlab {

// Sizes for which FFTW's transforms are fast.

/// The smallest even size of at least `least` without other prime factors than 2, 3 and 5.
inline std::size_t transform_size(double least)
{
    for (auto size = static_cast<std::size_t>(std::ceil(least));; ++size) {
        std::size_t rest = size;
        for (const std::size_t factor : {2, 3, 5}) {
            while (rest % factor == 0) rest /= factor;
        }
        if (rest == 1 && size % 2 == 0) return size;
    }
}

/// The number of lines that are transposed together: two cache lines of complex numbers.
inline constexpr std::size_t transposed_lines = 8;

/// Room for a line: whole blocks, and not a power of two, for which a cache has few places.
inline std::size_t padded_line(std::size_t size)
{
    return ((size + transposed_lines - 1) / transposed_lines | 1) * transposed_lines;
}

inline std::mutex fftw_planner;

struct DestroyFftwPlan
{
    void operator()(fftw_plan plan) const
    {
        const std::lock_guard lock(fftw_planner);
        fftw_destroy_plan(plan);
    }
};

using FftwPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyFftwPlan>;

/// The plan that `make`, one of FFTW's functions fftw_plan_..., makes of its arguments.
template <class... Parameters, class... Arguments>
FftwPlan make_fftw_plan(fftw_plan (*make)(Parameters...), Arguments... arguments)
{
    const std::lock_guard lock(fftw_planner);
    return FftwPlan(make(arguments...));
}

/// FFTW's complex numbers lie in memory as those of C++.
inline fftw_complex* fftw(std::complex<double>* values) { return reinterpret_cast<fftw_complex*>(values); }

}
