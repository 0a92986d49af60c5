// All eigenvectors of a stiffness and a mass whose eigenvalues lie in a band: stiffness x = eigenvalue mass x.
//
// Block Lanczos with a shift in the band, whose inverse makes its eigenvalues the largest (Grimes, Lewis, Simon, A
// shifted block Lanczos algorithm for solving sparse symmetric generalized eigenproblems, SIAM J. Matrix Anal. Appl.
// 15(1), 1994). How many there are is known before: a factorisation of stiffness - s mass has as many negative pivots
// as there are eigenvalues below s (Sylvester's law of inertia). Blocks find the equal eigenvalues that symmetric
// meshes have, which single vectors would miss.
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

/// The number of eigenvalues below a value that is none of them.
std::size_t eigenvalues_below(const Pencil& pencil, double value);

struct EigenvalueBand
{
    Eigen::VectorXd eigenvalues; ///< ascending
    Eigen::MatrixXd vectors;     ///< a column each, orthonormal by the mass
};

/// All eigenvalues from `low` to `high`, of which there are `count`. Throws InputError where some are not found.
EigenvalueBand eigenvalues_between(const Pencil& pencil, double low, double high, std::size_t count);

/// All eigenvalues of a small pencil from `low` to `high`, by a dense solver.
EigenvalueBand eigenvalues_of_small(const Pencil& pencil, double low, double high);

}
