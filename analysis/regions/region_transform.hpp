// The Fourier transform of a region, and the periodogram of points in it.
//
// The transform of a polygon is a sum over its edges, by Gauss's theorem:
//
//   W(f) = int over the region of exp(-2 pi i f.x) dx
//        = i / (2 pi |f|^2) sum over edges of (f x d) exp(-2 pi i f.m) sinc(f.d),
//
// m an edge's middle, d the way along it, f x d = f_x d_y - f_y d_x, sinc(t) = sin(pi t) / (pi t).
//
// The region's shape adds to the sums over points their expectation N W(f) / W(0), which is taken away:
//
//   P(f) = |sum over points of exp(-2 pi i f.x) - N W(f) / W(0)|^2 / N
//
// (the scattering intensity, directly debiased: Hawat, Gautier, Bardenet, Lachieze-Rey, On estimating the structure
// factor of a point process, with applications to hyperuniformity, Statistics and Computing 33, 2023, section 3;
// Rajala, Olhede, Grainger, Murrell, What is the Fourier transform of a spatial point process?, IEEE Transactions on
// Information Theory 69(8), 2023). Unlike that of the torus it is without bias on whole numbers f only as far as the
// region is large: W of it blurs spectra, over frequencies of one over its width. At frequency 0 it is 0: the number of
// points, which a torus has there, is what is taken away.
//
// Lengths are roots of the region's area, so that N points have N a unit square as on the torus; frequencies are whole.
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "analysis/spectra/half_spectrum.hpp"
#include "analysis/spectra/nonuniform_transform.hpp"

#include <complex>
#include <memory>
#include <span>

namespace poissonlab {

/// W(f) / W(0) by the sum over edges, for one frequency.
std::complex<double> region_transform(const FramedRegion& region, double x, double y);

/// W(f) / W(0) for all whole frequencies up to `reach` along each axis. Edges become places with weights, by Gauss's
/// rule on pieces in which no wave turns more than half, and these are transformed all at once. Errors are some 1e-7 of
/// the length of the boundary over 2 pi |f|, as NonuniformTransform has them.
HalfPlane region_transforms(const FramedRegion& region, int reach, NonuniformTransform& transform);

/// Sums over points in the frame, which may have weights, of exp(-2 pi i f.x), where `unit` lengths of the frame are 1:
/// by `fast`, if it is there, else exactly.
HalfPlane region_sums(const PointSet& points, std::span<const double> weights, double unit, int reach,
                      NonuniformTransform* fast);

/// A periodogram of n points of an even size: the squares of deviations(u, v) over n.
template <class Deviations>
void fill_with_powers(HalfSpectrum& result, int size, double n, const Deviations& deviations)
{
    result.dimension = 2;
    result.size = size;
    const std::size_t rows = result.rows();
    result.power.resize(result.columns() * rows);
    const int reach = size / 2;
    for (int u = 0; u <= reach; ++u)
        for (int v = -reach; v <= reach; ++v)
            result.power[static_cast<std::size_t>(u) * rows + static_cast<std::size_t>(v + reach)] =
                std::norm(deviations(u, v)) / n;
}

class RegionPeriodogram
{
public:
    /// Frequencies of a spectrum of that even size. `is_exact`: by the sums over points and edges; otherwise with
    /// errors as above.
    RegionPeriodogram(std::shared_ptr<const FramedRegion> region, int size, bool is_exact);
    ~RegionPeriodogram();

    /// Takes points in the frame.
    void compute(const PointSet& points, HalfSpectrum& result);

private:
    std::shared_ptr<const FramedRegion> region_;
    int size_;
    std::unique_ptr<NonuniformTransform> fast_; ///< none: exact
    HalfPlane window_;                          ///< W(f) / W(0)
};

}
