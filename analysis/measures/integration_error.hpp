// The error of integrating with a point set: the mean of a function over the points against its integral.
//
// Errors are averaged over random toroidal shifts of each set, Cranley and Patterson, Randomization of number
// theoretic methods for multiple integration, SIAM J. Numer. Anal. 13(6), 1976, and then over K sets. Over
// all shifts the error has mean 0 and the variance
//
//   E[e^2] = 1/N sum over integer f != 0 of |F(f)|^2 P(f),
//
// F the Fourier coefficients of the function on the unit torus and P the periodogram (Pilleboue et al.,
// Variance analysis for Monte Carlo integration, ACM Transactions on Graphics 34(4), 2015): the measure says
// of a method what its spectrum says, weighted by functions that people integrate. White noise has P = 1 and
// E[e^2] = sigma^2 / N, with sigma^2 the variance of the function.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// A function on the unit square or cube with what is known of it.
struct Integrand
{
    std::string name;
    double integral = 0;
    double variance = 0; ///< sigma^2: the integral of the square less the square of the integral
    double (*value)(std::span<const double> position) = nullptr;
};

/// The test functions, d the dimension:
/// - "disk" ("ball" in 3D): 1 within 0.3 of (0.5, ...), else 0
/// - "step": 1 below the line y = 0.2 + x / golden ratio, in 3D below the plane
///   z = 0.15 + (sqrt 2 - 1) x + (sqrt 3 - 3/2) y: both leave the square (cube) through its sides only
/// - "gaussian": exp(-|x - c|^2 / (2 0.2^2)) around the centre c, cut off by the borders
/// - "cosine": product of 1 + cos(2 pi x_k), smooth on the torus
/// - "bilinear" ("trilinear"): product of x_k, with a jump at the borders of the torus
/// `dimension` 2 or 3, otherwise InputError.
const std::vector<Integrand>& integrands(int dimension);

/// One integrand, over all sets and shifts.
struct IntegrationError
{
    std::string integrand;
    double integral = 0;          ///< exact
    double rms_error = 0;         ///< root of the mean of e^2
    double standard_error = 0;    ///< of rms_error, from the K sets' own means of e^2; 0 where K = 1
    double relative_variance = 0; ///< mean of N e^2 / sigma^2: 1 is the level of Monte Carlo

    bool operator==(const IntegrationError&) const = default;
};

/// Averages over sets, in the order given. Shifts are a function of seed, number of the set and number of the
/// shift; any number of threads gives the same bytes.
class IntegrationErrorEstimate
{
public:
    /// `shifts` of each set; `first` is the number of the first set, where others are elsewhere. Throws InputError
    /// unless shifts > 0 and dimension 2 or 3.
    IntegrationErrorEstimate(int dimension, std::uint64_t seed, int shifts = 16, std::size_t first = 0);

    /// Adds one set; sizes may vary. Throws InputError for another dimension or an empty set. Coordinates
    /// must lie in [0, 1).
    void add(const PointSet& points);

    /// Adds a set on disk, by sums over its strips. These have another order than sums in memory, so that errors differ
    /// by the rounding of means of N numbers of size 1, some sqrt(N) 1e-16 of one.
    void add(const PointStrips& points);

    /// Appends the sets of `other`, which begins with the number after the last one here; equal to adding them here.
    void append(const IntegrationErrorEstimate& other);

    /// One entry an integrand, in the order of integrands(); none where no set was added. Errors are between the
    /// `groups` of sets, see errors_of_mean().
    std::vector<IntegrationError> mean(const std::vector<std::size_t>& groups = {}) const;

    /// The sums as bytes, which are read into an estimate that was constructed alike.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(squares_, sizes_);
    }

private:
    using Sums = std::vector<std::vector<double>>; ///< over points, of each shift and integrand

    void sum(const PointSet& points, Sums& sums) const;
    void add_sums(const Sums& sums, std::uint64_t points);

    int dimension_;
    std::uint64_t seed_;
    int shifts_;
    std::size_t first_;
    std::vector<std::vector<double>> squares_; ///< [set][integrand], mean of e^2 over the shifts
    std::vector<double> sizes_;                ///< N of each set
};

}
