// The power spectrum of points on a surface.
//
// It is the power in the eigenfunctions of the Laplacian, which take the place of the torus's cosines and sines
// (Bowers, Wang, Wei, Maletz, Parallel Poisson disk sampling with spectrum analysis on surfaces, ACM Transactions on
// Graphics 29(6), 2010). They are found among functions that are linear on each triangle, in bands of eigenvalues
// (Vallet, Levy, Spectral geometry processing with manifold harmonics, Computer Graphics Forum 27(2), 2008); open
// borders have Neumann's condition. The mass is the mean of the consistent and of the lumped one, whose errors are
// opposite: on equilateral triangles of side h they change an eigenvalue k^2 by the factors 1 + (kh)^2 / 16 and 1 -
// (kh)^2 / 16, and their mean leaves an error of the order (kh)^4.
#pragma once

#include "base/surfaces/triangle_tree.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace poissonlab {

/// Edges may have at most this part of the shortest wavelength.
inline constexpr double longest_edge_in_wavelengths = 0.3;

struct EigenfunctionPowers
{
    std::vector<double> eigenvalues;         ///< ascending, those of constant functions left out; in the mesh's units
    std::vector<std::vector<double>> powers; ///< powers[set][eigenfunction]; random points have 1 on average
};

/// This function is called with the number of eigenfunctions found so far.
using EigenfunctionProgress = std::function<void(std::size_t found, std::size_t all)>;

/// Finds all eigenfunctions with eigenvalues up to `highest`. The power of N points x_i in an eigenfunction phi, whose
/// square has the integral 1, is area / N |sum_i phi(x_i)|^2. A mesh has no vertex without triangles. Results do not
/// depend on the number of threads. Throws InputError where eigenfunctions are not found.
EigenfunctionPowers eigenfunction_powers(const TriangleMesh& mesh, double highest,
                                         const std::vector<std::vector<MeshPosition>>& sets,
                                         const EigenfunctionProgress& on_progress = {});

/// Throws InputError if the bases of all threads for a mesh of so many vertices need more memory than there is.
void check_room_for_eigenfunctions(double vertices);

/// Returns the approximate number of eigenfunctions up to a frequency (cycles per unit length) on this area, by Weyl's
/// law.
double eigenfunctions_up_to(double frequency, double area);

/// Returns the frequency up to which there are about `count` eigenfunctions.
double frequency_of_eigenfunctions(double count, double area);

/// Returns 4 pi^2 frequency^2.
double eigenvalue_of(double frequency);
double frequency_of(double eigenvalue);

}
