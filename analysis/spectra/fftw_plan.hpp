// Plans of FFTW, whose planner serves one thread at a time: all plans are made and destroyed under one lock.
#pragma once

#include <fftw3.h>

#include <complex>
#include <memory>
#include <mutex>
#include <type_traits>

namespace poissonlab {

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
