// Phases along one axis, expanded in Chebyshev polynomials on strips of the torus: what shrinks the inner
// dimension of the periodogram's matrix products from the number of points to a number of strip moments.
//
// Cut [0, 1) into B strips of half width h = 1/(2B) with centres c_k, so that y = c_k + h t with |t| <= 1 in
// strip k. The Jacobi-Anger expansion (Abramowitz and Stegun, 9.1.44 and 9.1.45) with z = 2 pi v h is
//
//   exp(2 pi i v y) = exp(2 pi i v c_k) sum_r (2 - [r = 0]) i^r J_r(z) T_r(t).
//
// J_r(z) falls faster than any power of r once r > z, so that R terms suffice for every double: the rest is
// below 2 (z/2)^R / R! / (1 - z/(2R + 2)), and R is chosen to push that below 2^-53. There is
// nothing to tune: what is cut off is smaller than one rounding error of the phase itself.
//
// Points with values g_j then enter through the strip moments G_kr = sum_{j in k} g_j T_r(t_j) only:
//
//   sum_j g_j cos(2 pi v y_j) = sum_kr C_v(k, r) G_kr
//   C_v(k, r) = (2 - [r = 0]) J_r(z) cos(2 pi v c_k + r pi/2)
//
// and likewise with sin and S_v. Strip centres are evenly spaced, so C and S repeat up to sign: strip k, its
// reflection in 1/4, and both shifted by 1/2 share their coefficients. `fold` adds such moments first; a
// quarter of them remains.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace poissonlab {

/// B strips and R Chebyshev polynomials a strip.
struct StripExpansion
{
    int strips = 4; ///< B, a power of two, at least 4
    int terms = 1;  ///< R

    /// The moments that remain after folding.
    std::size_t folded_moments() const { return static_cast<std::size_t>(strips / 4) * terms; }
};

/// The number of terms with which B strips carry all frequencies up to `max_frequency` to double precision.
int expansion_terms(int strips, int max_frequency);

/// The expansion with the fewest operations for a periodogram of `points` points with `size` samples an axis:
/// many strips make long lists of moments, few strips make expensive moments.
StripExpansion cheapest_expansion(std::size_t points, int size);

/// The coefficients C_v and S_v for v = 0 .. max_frequency on the first quarter of the strips, even and odd v
/// apart: row v / 2, column k * terms + r.
struct StripCoefficients
{
    std::array<std::vector<double>, 2> cosine; ///< [v % 2]
    std::array<std::vector<double>, 2> sine;   ///< [v % 2]
};

StripCoefficients strip_coefficients(const StripExpansion& expansion, int max_frequency);

/// The four strips whose moments are folded into those of strip k < B/4.
std::array<int, 4> folded_strips(const StripExpansion& expansion, int k);

/// Moments of four strips, row r of `columns` values each, folded for one parity of v:
/// `cosine` and `sine` receive what the rows (k, r) of C_v and S_v multiply.
void fold(const std::array<const double*, 4>& moments, int terms, std::size_t columns, bool odd_frequency,
          double* cosine, double* sine);

}
