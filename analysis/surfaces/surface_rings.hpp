// The power of eigenfunctions as rings of frequencies, such as those of the plane's spectra, for the same measures.
//
// On a surface of area A, eigenfunctions up to the frequency f, sqrt(eigenvalue) / 2 pi, are nearly pi A f^2 (Weyl's
// law), as many as the plane's frequencies that are apart by 1 / sqrt A along both axes. Eigenfunctions are real: two
// take the place of a frequency f and its opposite, whose powers are equal. Hence neighbours are taken in pairs, whose
// mean power has of random points an exponential law as that of a frequency has, and what holds of the plane's rings
// holds of these.
#pragma once

#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/surfaces/refined_mesh.hpp"
#include "analysis/surfaces/triangle_tree.hpp"

#include <vector>

namespace poissonlab {

/// Rings 1, 2, ... hold the eigenfunctions with 1/2 + (k - 1) w < f sqrt A <= 1/2 + k w, w = `width`, the first one
/// also those below, and end at `highest`, an eigenvalue. Rings without any are left out. Frequencies are f sqrt A.
/// Errors of the mean power follow from the number of eigenfunctions, of one set of random points.
std::vector<RadialBin> eigenfunction_rings(const std::vector<double>& eigenvalues, const std::vector<double>& powers,
                                           double area, double highest, double width = 1);

/// How evenly points are spread over the parts of a surface.
struct CountsOverParts
{
    std::size_t parts = 0; ///< of nearly equal area, a power of two; 0: there are too few points
    double chi_square = 0; ///< sum of (count - expected)^2 / expected
    double p_value = 1;    ///< the probability of at least as much for random points
};

/// Divides the surface by halving the box around its triangles, until a part expects `least` points or there are `most`
/// parts.
CountsOverParts counts_over_parts(const TriangleMesh& mesh, const std::vector<MeshPosition>& points, double least = 10,
                                  std::size_t most = 64);

}
