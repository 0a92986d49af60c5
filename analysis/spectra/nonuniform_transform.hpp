// The Fourier transform of points in the plane, and its adjoint: from frequencies back to the points.
//
// Dutt, Rokhlin, Fast Fourier transforms for nonequispaced data, SIAM Journal on Scientific Computing 14(6), 1993, with
// the kernel of spreading_kernel.hpp. FFTW's results depend on the processor in their last bits, and so do these; the
// number of threads changes nothing.
#pragma once

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

    explicit HalfPlane(int to) : reach(to), values(columns() * static_cast<std::size_t>(2 * to + 1)) {}

    std::size_t columns() const { return static_cast<std::size_t>(reach) + 1; }
    std::complex<double>& at(int u, int v)
    {
        return values[static_cast<std::size_t>(v + reach) * columns() + static_cast<std::size_t>(u)];
    }
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

    /// F(f) = sum_j w_j exp(-2 pi i f.x_j) of points with weights w_j; without weights, all w_j are 1.
    HalfPlane forward(const PointSet& points, std::span<const double> weights);

    /// G(x_j) = sum_f C(f) exp(2 pi i f.x_j) over all frequencies, with C(-f) the conjugate of C(f).
    std::vector<double> adjoint(const HalfPlane& coefficients, const PointSet& points);

    /// The derivatives of G along x and y at each point, by those of the kernel. Errors are some 1e-6 of the sum of all
    /// magnitudes of derivatives at the largest frequency.
    std::vector<double> adjoint_gradient(const HalfPlane& coefficients, const PointSet& points);

private:
    class Plan;
    std::unique_ptr<Plan> plan_;
};

}
