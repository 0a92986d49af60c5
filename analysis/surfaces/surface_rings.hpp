// Averages the power of eigenfunctions over rings of frequencies, to which the measures of the plane's spectra apply.
//
// On a surface of area A, eigenfunctions up to the frequency f, sqrt(eigenvalue) / 2 pi, are nearly pi A f^2 (Weyl's
// law), as many as the plane's frequencies that are apart by 1 / sqrt A along both axes. Eigenfunctions are real: two
// take the place of a frequency f and its opposite, whose powers are equal. Neighbours are therefore taken in pairs:
// for random points the mean power of a pair is distributed exponentially, as the power at a frequency of the plane is,
// so that the laws of the plane's rings hold here.
#pragma once

#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/surfaces/refined_mesh.hpp"
#include "base/surfaces/triangle_tree.hpp"

#include <vector>

namespace poissonlab {

/// Returns rings k = 1, 2, ..., which hold the eigenfunctions with 1/2 + (k - 1) w < f sqrt A <= 1/2 + k w, where w is
/// `width`; the first ring also has all below. Rings end at the eigenvalue `highest`, and empty rings are left out.
/// Frequencies are f sqrt A. Errors of the mean power are those of one set of random points with this number of
/// eigenfunctions.
std::vector<RadialBin> eigenfunction_rings(const std::vector<double>& eigenvalues, const std::vector<double>& powers,
                                           double area, double highest, double width = 1);

/// Describes how evenly points are spread over the parts of a surface.
struct CountsOverParts
{
    std::size_t parts = 0;              ///< of nearly equal area, if triangles are small; 0: there are too few points
    double chi_square = 0;              ///< sum of (count - expected)^2 / expected
    double p_value = 1;                 ///< the probability that random points have at least as much
    std::vector<std::uint32_t> part_of; ///< the part of each triangle; empty: there are too few points
};

/// Halves the surface by area along the longest side of its box, and so on, as long as each part has `least` expected
/// points and there are at most `most` parts.
CountsOverParts counts_over_parts(const TriangleMesh& mesh, const std::vector<MeshPosition>& points, double least = 10,
                                  std::size_t most = 64);

}
