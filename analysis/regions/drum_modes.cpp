// Inverse iteration of a subspace, with Rayleigh and Ritz's step in it (Bathe, Wilson, Large eigenvalue problems in
// dynamic analysis, Journal of the Engineering Mechanics Division 98, 1972).
#include "analysis/regions/drum_modes.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double small_residual = 1e-9;
constexpr int most_steps = 500;

/// After all steps a mode may have up to this residual, relative to its forces. Masses of bilinear elements have a
/// condition of 9 at most, so that an eigenvalue is within three residuals of that of a vibration; boundaries that are
/// moved by a cell of a 128th at either end move eigenvalues by a 64th or so, which is more. Modes are orthogonal
/// whatever is left.
constexpr double largest_residual = 1.0 / (3 * 64);

/// Rows of mass and stiffness of a chain of linear elements: what a node shares with itself and with its neighbours.
struct Chain
{
    std::array<double, 2> mass, stiffness;

    explicit Chain(double step) : mass{4 * step / 6, step / 6}, stiffness{2 / step, -1 / step} {}
};

struct Matrices
{
    Sparse mass, stiffness;
};

Matrices matrices_of(std::span<const std::size_t> number, std::size_t columns, std::array<double, 2> step)
{
    const Chain along_x(step[0]), along_y(step[1]);
    std::vector<Eigen::Triplet<double, int>> mass, stiffness;
    std::size_t count = 0;
    for (std::size_t node = 0; node < number.size(); ++node) {
        if (number[node] == no_node) continue;
        ++count;
        for (std::size_t dy = 0; dy < 3; ++dy)
            for (std::size_t dx = 0; dx < 3; ++dx) {
                const std::size_t other = number[node + (dy * columns + dx) - (columns + 1)];
                if (other == no_node) continue;
                const std::size_t x = dx == 1 ? 0 : 1, y = dy == 1 ? 0 : 1;
                const int row = static_cast<int>(number[node]), column = static_cast<int>(other);
                mass.emplace_back(row, column, along_x.mass[x] * along_y.mass[y]);
                stiffness.emplace_back(row, column,
                                       along_x.stiffness[x] * along_y.mass[y] + along_x.mass[x] * along_y.stiffness[y]);
            }
    }
    const auto size = static_cast<Eigen::Index>(count);
    Matrices matrices{Sparse(size, size), Sparse(size, size)};
    matrices.mass.setFromTriplets(mass.begin(), mass.end());
    matrices.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
    return matrices;
}

/// Vectors that have something of every mode: Kronecker sequences.
Eigen::MatrixXd start_vectors(Eigen::Index nodes, Eigen::Index count)
{
    Eigen::MatrixXd vectors(nodes, count);
    for (Eigen::Index k = 0; k < count; ++k)
        for (Eigen::Index i = 0; i < nodes; ++i) {
            const double turns = static_cast<double>(i + 1) * std::sqrt(static_cast<double>(k + 2) + 0.5);
            vectors(i, k) = turns - std::floor(turns) - 0.5;
        }
    return vectors;
}

/// The largest value of a mode counts as positive, so that signs do not depend on how it was found.
std::vector<double> with_sign(const Eigen::VectorXd& mode)
{
    Eigen::Index largest = 0;
    for (Eigen::Index i = 1; i < mode.size(); ++i)
        if (std::abs(mode[i]) > std::abs(mode[largest]) * (1 + small_residual)) largest = i;
    const double sign = mode[largest] < 0 ? -1 : 1;
    std::vector<double> values(static_cast<std::size_t>(mode.size()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = sign * mode[static_cast<Eigen::Index>(i)];
    return values;
}

InputError not_found(std::size_t count)
{
    return InputError(
        fmt::format("{} tapers of this region cannot be told apart so closely: fewer tapers can be found", count));
}

}

DrumModes drum_modes(std::span<const std::size_t> number, std::size_t columns, std::array<double, 2> step,
                     std::size_t count)
{
    const Matrices drum = matrices_of(number, columns, step);
    const Eigen::SimplicialLLT<Sparse> inverse(drum.stiffness);
    if (inverse.info() != Eigen::Success) throw not_found(count);
    const auto wanted = static_cast<Eigen::Index>(count);
    const Eigen::Index block = std::min(drum.mass.rows(), wanted + std::max<Eigen::Index>(8, wanted / 2));
    Eigen::MatrixXd vectors = start_vectors(drum.mass.rows(), block);
    Eigen::VectorXd eigenvalues;
    double largest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most_steps && !(largest < small_residual); ++k) {
        stop_if_interrupted();
        const Eigen::MatrixXd solved = inverse.solve(drum.mass * vectors);
        const Eigen::MatrixXd stiff = drum.stiffness * solved, massive = drum.mass * solved;
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(solved.transpose() * stiff,
                                                                             solved.transpose() * massive);
        vectors = solved * ritz.eigenvectors();
        eigenvalues = ritz.eigenvalues();
        const Eigen::MatrixXd forces = massive * ritz.eigenvectors() * eigenvalues.asDiagonal();
        const Eigen::MatrixXd residual = stiff * ritz.eigenvectors() - forces;
        largest = 0;
        for (Eigen::Index i = 0; i < wanted; ++i)
            largest = std::max(largest, residual.col(i).norm() / forces.col(i).norm());
    }
    if (!(largest < largest_residual)) throw not_found(count);
    DrumModes modes;
    for (Eigen::Index i = 0; i < wanted; ++i) {
        modes.values.push_back(with_sign(vectors.col(i)));
        modes.eigenvalues.push_back(eigenvalues[i]);
    }
    return modes;
}

}
