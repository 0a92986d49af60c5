// Finds all eigenvectors of a stiffness and a mass whose eigenvalues lie in a band: stiffness x = eigenvalue mass x.
//
// The method is block Lanczos with a shift in the band: the inverse of the shifted pencil has its largest eigenvalues
// there (Grimes, Lewis, Simon, A shifted block Lanczos algorithm for solving sparse symmetric generalized
// eigenproblems, SIAM J. Matrix Anal. Appl. 15(1), 1994). The number of eigenvalues is known in advance: a
// factorisation of stiffness - s mass has as many negative pivots as there are eigenvalues below s (Sylvester's law of
// inertia). Blocks find the equal eigenvalues that symmetric meshes have, which single vectors would miss.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cstddef>

namespace poissonlab {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct Pencil
{
    SparseMatrix stiffness; ///< symmetric, no eigenvalue below 0
    SparseMatrix mass;      ///< symmetric, positive definite
};

/// Returns the number of eigenvalues below `value`, which must not be an eigenvalue itself.
std::size_t eigenvalues_below(const Pencil& pencil, double value);

struct EigenvalueBand
{
    Eigen::VectorXd eigenvalues; ///< ascending
    Eigen::MatrixXd vectors;     ///< a column each, orthonormal by the mass
};

/// The columns that the basis for `count` eigenvalues has at most.
std::size_t most_basis_size(std::size_t count);

/// Finds all eigenvalues from `low` to `high`, of which there are `count`. Throws InputError if some are not found.
EigenvalueBand eigenvalues_between(const Pencil& pencil, double low, double high, std::size_t count);

/// Finds all eigenvalues of a small pencil from `low` to `high`, by a dense solver.
EigenvalueBand eigenvalues_of_small(const Pencil& pencil, double low, double high);

}
