// Pairs of points in a region over their distance: Ripley's K and the pair correlation g, with edge corrections.
//
//   K(r) = n / (n - 1) sum over ordered pairs no farther apart than r of w_ij / (l_i l_j)
//   g(r) = n / (n - 1) sum over ordered pairs of k(r - d) w_ij / (2 pi d l_i l_j)
//
// where l is the intensity at a point, n / A for a set without density, so that K is pi r^2 and g 1 on average for n
// independent points that follow the intensity. w_ij is 1 / C(x_i - x_j), C the set covariance, with the translation
// correction (Ohser 1983), and 1 / (A times the share in the region of the circle around x_i through x_j) with Ripley's
// isotropic one (Ripley, Modelling spatial patterns, Journal of the Royal Statistical Society B 39(2), 1977), at most
// 100 / A. k is Epanechnikov's kernel, and d stands where r may as well: it is less biased at short distances (Guan, A
// least-squares cross-validation bandwidth selection approach in pair correlation function estimations, Statistics and
// Probability Letters 77(18), 2007; in spatstat, pcf(divisor = "d")). With a density these are the inhomogeneous K and
// g (Baddeley, Moller, Waagepetersen, Non- and semi-parametric estimation of interaction in inhomogeneous point
// patterns, Statistica Neerlandica 54(3), 2000).
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "analysis/regions/set_covariance.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

/// Curves at the ends of bins of equal width from distance 0 on, in the frame.
struct PairCurves
{
    std::vector<double> pairs;         ///< unordered, of each bin
    std::vector<double> k_translation; ///< up to the end of the bin
    std::vector<double> k_isotropic;
    std::vector<double> g_of_bin; ///< of the whole bin, by the translation correction
    std::vector<double> g_smooth; ///< at the end of the bin, by Epanechnikov's kernel
};

/// The distances at which curves are measured.
struct PairDistances
{
    double step = 0;
    std::size_t count = 0;
    double half_width = 0; ///< of Epanechnikov's kernel

    double reach() const { return step * static_cast<double>(count); }
};

/// The curves of two points or more; points that coincide count for K, but not for g_smooth. `intensity`: at each
/// point, in points per square of the frame; empty: the same everywhere. Any number of threads gives the same bytes.
/// Without `is_isotropic` there is no k_isotropic.
PairCurves region_pairs(const PointSet& points, const FramedRegion& region, const SetCovariance& covariance,
                        const PairDistances& distances, std::span<const double> intensity = {},
                        bool is_isotropic = true);

}
