// The covariance of the spectra by the tapers of a region.
//
// The tapers of a region are orthogonal, which makes their powers independent at one frequency. At two frequencies they
// are not: where the powers of frequencies are those of chance, and change little over the width of the tapers'
// transforms, the powers of tapers k and l at frequencies f and g have the covariance
//
//   S(f)^2 (|H_kl(f - g)|^2 + |H_kl(f + g)|^2),   H_kl(d) = integral of h_k h_l exp(-2 pi i d.x)
//
// (Thomson, Spectrum estimation and harmonic analysis, Proceedings of the IEEE 70(9), 1982; Walden, A unified view of
// multitaper multivariate spectral estimation, Biometrika 87(4), 2000). The mean over T tapers at one frequency has the
// variance S^2 / T. The mean over a ring of frequencies has not: neighbours in a ring say much the same, and so do
// rings beside each other. In a square, rings of eight tapers have 0.4 of the variance that those without tapers have.
#pragma once

#include "analysis/regions/region_tapers.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace poissonlab {

/// The covariances of the mean powers of rings, over the product of their powers. Rings are the bins of
/// radial_statistics(), the first one is 0.
class RingCovariance
{
public:
    /// `bands[b][d]` is that of rings b and b + d; it is 0 for those that are farther apart than a ring has bands.
    explicit RingCovariance(std::vector<std::vector<double>> bands) : bands_(std::move(bands)) {}

    std::size_t rings() const { return bands_.size(); }
    double of(std::size_t first, std::size_t second) const;

    /// The standard error of each ring of a mean curve.
    std::vector<double> errors(const std::vector<double>& power) const;

    /// The standard error of a statistic of a mean curve, as far as that is linear over an error of each ring.
    double error_of(const std::vector<double>& power,
                    const std::function<double(const std::vector<double>& power)>& statistic) const;

private:
    std::vector<std::vector<double>> bands_;
};

class TaperCovariance
{
public:
    explicit TaperCovariance(const RegionTapers& tapers);

    /// The mean over all pairs of tapers of |H_kl(d)|^2, at whole differences d of frequencies, in units of one over
    /// the root of the region's area: 1 / T for 0. It is 0 beyond reach() along an axis, where next to nothing is left.
    double at(int u, int v) const;
    int reach() const { return reach_; }

    /// Rings of a spectrum of that size. Sums are over all their frequencies up to a radius, beyond which a ring has as
    /// many independent frequencies a length as those below.
    RingCovariance of_rings(int size, double bin_width) const;

private:
    int reach_ = 0;
    std::vector<double> squares_; ///< at (u, v), v slowest, both from -reach_
};

}
