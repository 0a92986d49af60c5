// The Fourier transform of points in the plane, and its adjoint: from frequencies back to the points.
//
// Dutt, Rokhlin, Fast Fourier transforms for nonequispaced data, SIAM Journal on Scientific Computing 14(6), 1993, with
// the kernel of spreading_kernel.hpp. FFTW's results depend on the processor in their last bits, and so do these.
#pragma once

#include "analysis/spectra/spreading_kernel.hpp"
#include "base/geometry/point_set.hpp"

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace poissonlab {

/// Values for frequencies u = 0 .. reach along x, fastest, and v = -reach .. reach along y; those of negative u are
/// their conjugates.
struct HalfPlane
{
    int reach = 0;
    std::vector<std::complex<double>> values;

    explicit HalfPlane(int to) : reach(to), values(static_cast<std::size_t>((2 * to + 1) * (to + 1))) {}

    std::complex<double>& at(int u, int v) { return values[static_cast<std::size_t>((v + reach) * (reach + 1) + u)]; }
    const std::complex<double>& at(int u, int v) const { return const_cast<HalfPlane*>(this)->at(u, v); }
};

class NonuniformTransform
{
public:
    /// Frequencies up to `reach` >= 1 along each axis. Errors are some 1e-7 of the sum of all magnitudes.
    explicit NonuniformTransform(int reach);
    ~NonuniformTransform();
    NonuniformTransform(NonuniformTransform&&) noexcept;

    /// F(f) = sum_j exp(-2 pi i f.x_j). Points in 2D, coordinates in [0, 1).
    HalfPlane forward(const PointSet& points) { return forward(points, {}); }

    /// The same of points with weights.
    HalfPlane forward(const PointSet& points, std::span<const double> weights);

    /// G(x_j) = sum_f C(f) exp(2 pi i f.x_j) over all frequencies, with C(-f) the conjugate of C(f).
    std::vector<double> adjoint(const HalfPlane& coefficients, const PointSet& points);

private:
    struct Plans;

    /// The grid points under the kernel around a coordinate: the first, and their weights.
    int weights_at(double coordinate, double* weights) const;
    template <typename What>
    void for_each_weight(const PointSet& points, std::size_t point, What&& what) const;

    int reach_, grid_;
    SpreadingKernel kernel_;
    std::vector<double> corrections_; ///< 1 / transform of the kernel, of frequency 0 .. reach
    std::unique_ptr<Plans> plans_;
};

}
