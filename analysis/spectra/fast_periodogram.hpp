// The periodogram by a nonuniform fast Fourier transform of type 1, for any number of points.
//
// Points are spread onto a finer grid with a compact kernel, the grid is transformed by FFTW, and the
// kernel's transform is divided out (Dutt, Rokhlin: Fast Fourier Transforms for Nonequispaced Data, 1993;
// kernel and error: see spreading_kernel.hpp). Points are never rounded to the grid. This is
// what FINUFFT does; Debian does not have it.
#pragma once

#include "analysis/spectra/half_spectrum.hpp"
#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

#include <cstddef>
#include <memory>

namespace poissonlab {

/// Plans and tables for periodograms of one size.
///
/// Relative l2 error of the transform values: at most `tolerance`, which can be 1e-8 to 0.1. The same
/// bytes on every run and for any number of threads: FFTW's plans are estimated, not measured, and work is
/// divided by lines. Memory: 1.25 M * M / 2 complex doubles, in 3D (1.5 M)^2 M / 2, and 1.5 M * M for each
/// thread; 8 bytes a point; and `band_bytes` for the points' kernels, some 250 bytes each, which are made for a band of
/// lines at a time where they take more. That changes no byte of the result.
class FastPeriodogram
{
public:
    static constexpr double default_tolerance = 1e-8;
    static constexpr std::size_t default_band_bytes = std::size_t{1} << 30;

    /// `size`: M, even and positive; else, or for a tolerance outside of its range, std::invalid_argument.
    FastPeriodogram(int dimension, int size, double tolerance = default_tolerance,
                    std::size_t band_bytes = default_band_bytes);
    ~FastPeriodogram();
    FastPeriodogram(FastPeriodogram&&) noexcept;
    FastPeriodogram& operator=(FastPeriodogram&&) noexcept;

    /// Coordinates in [0, 1), at least one point, the dimension as above (std::invalid_argument).
    HalfSpectrum compute(const PointSet& points);

    /// Computes a periodogram into memory that is there already: fresh memory takes a good part of the time.
    void compute(const PointSet& points, HalfSpectrum& result);

    /// Computes the periodogram of a set on disk, of which a strip and what touches it is in memory at a time. Points
    /// of a grid line that come from two strips are added up in another order: transform values differ by rounding,
    /// some 1e-16 of the sum of all magnitudes, far below the tolerance.
    void compute(const PointStrips& points, HalfSpectrum& result);

private:
    class Plan;
    std::unique_ptr<Plan> plan_;
};

}
