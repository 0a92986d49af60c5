// Inverse iteration of a subspace, with Rayleigh and Ritz's step in it (Bathe, Wilson, Large eigenvalue problems in
// dynamic analysis, Journal of the Engineering Mechanics Division 98, 1972).
#include "analysis/regions/region_tapers.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLLT<Sparse>;

constexpr double small_residual = 1e-9;
constexpr int most_steps = 500;

/// In long regions eigenvalues are differences of far larger numbers.
constexpr double small_residual_of_long = 1e-6;
constexpr int most_steps_of_long = 60;

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

Matrices matrices_of(const TaperGrid& grid, std::array<double, 2> step)
{
    const Chain along_x(step[0]), along_y(step[1]);
    std::vector<Eigen::Triplet<double, int>> mass, stiffness;
    for (std::size_t line = 0; line < grid.rows(); ++line)
        for (std::size_t node = grid.row_begin(line); node < grid.row_begin(line + 1); ++node)
            for (std::size_t dy = 0; dy < 3; ++dy)
                for (std::size_t dx = 0; dx < 3; ++dx) {
                    const std::size_t other = grid.number(grid.column(node) + dx - 1, line + dy - 1);
                    if (other == no_node) continue;
                    const std::size_t x = dx == 1 ? 0 : 1, y = dy == 1 ? 0 : 1;
                    const int row = static_cast<int>(node), column = static_cast<int>(other);
                    mass.emplace_back(row, column, along_x.mass[x] * along_y.mass[y]);
                    stiffness.emplace_back(
                        row, column, along_x.stiffness[x] * along_y.mass[y] + along_x.mass[x] * along_y.stiffness[y]);
                }
    const auto size = static_cast<Eigen::Index>(grid.size());
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

/// Subtracts from the stiffness the potential that makes u its lowest mode, with the eigenvalue 0 in each part of the
/// region. Here u is the solution under a load of 1 everywhere. Modes are then u times g, and their energy that is left
/// is the integral of u^2 |grad g|^2.
Matrices released_of(const Matrices& drum)
{
    const Eigen::VectorXd load = drum.mass * Eigen::VectorXd::Ones(drum.mass.rows());
    const Factor inverse(drum.stiffness);
    if (inverse.info() != Eigen::Success) throw not_found(1);
    const Eigen::VectorXd u = inverse.solve(load), forces = drum.stiffness * u;
    Matrices released = drum;
    for (Eigen::Index i = 0; i < u.size(); ++i) released.stiffness.coeffRef(i, i) -= forces[i] / u[i];
    return released;
}

/// A block of vectors that become the lowest modes.
class Subspace
{
public:
    /// Finds the modes of `stiffness` by the inverse of it and `lift` masses.
    Subspace(const Matrices& drum, double lift, Eigen::Index wanted)
        : drum_(drum), inverse_(lift == 0 ? drum.stiffness : Sparse(drum.stiffness + lift * drum.mass)), lift_(lift),
          wanted_(wanted),
          vectors_(start_vectors(drum.mass.rows(),
                                 std::min(drum.mass.rows(), wanted + std::max<Eigen::Index>(8, wanted / 2))))
    {
        if (inverse_.info() != Eigen::Success) throw not_found(static_cast<std::size_t>(wanted));
    }

    const Eigen::VectorXd& eigenvalues() const { return eigenvalues_; }

    /// Throws InputError where modes are not found in so many steps.
    void find(int most, double small)
    {
        double residual = std::numeric_limits<double>::infinity();
        for (int k = 0; k < most && !(residual < small); ++k) residual = step();
        if (!(residual < largest_residual)) throw not_found(static_cast<std::size_t>(wanted_));
    }

    /// The modes that are wanted, without eigenvalues.
    DrumModes found() const
    {
        DrumModes modes;
        for (Eigen::Index i = 0; i < wanted_; ++i) modes.values.push_back(with_sign(vectors_.col(i)));
        return modes;
    }

private:
    /// Returns the largest residual of a mode that is wanted, relative to its forces and those of the lift.
    double step()
    {
        stop_if_interrupted();
        const Eigen::MatrixXd loads = drum_.mass * vectors_;
        Eigen::MatrixXd solved(loads.rows(), loads.cols());
        tbb::parallel_for(Eigen::Index{0}, loads.cols(),
                          [&](Eigen::Index k) { solved.col(k) = inverse_.solve(loads.col(k)); });
        const Eigen::MatrixXd stiff = drum_.stiffness * solved, massive = drum_.mass * solved;
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz(solved.transpose() * stiff,
                                                                             solved.transpose() * massive);
        vectors_ = solved * ritz.eigenvectors();
        eigenvalues_ = ritz.eigenvalues();
        const Eigen::MatrixXd masses = massive * ritz.eigenvectors();
        const Eigen::MatrixXd residual = stiff * ritz.eigenvectors() - masses * eigenvalues_.asDiagonal();
        double largest = 0;
        for (Eigen::Index i = 0; i < wanted_; ++i)
            largest = std::max(largest, residual.col(i).norm() / (masses.col(i) * (eigenvalues_[i] + lift_)).norm());
        return largest;
    }

    const Matrices& drum_;
    Factor inverse_;
    double lift_;
    Eigen::Index wanted_;
    Eigen::MatrixXd vectors_;
    Eigen::VectorXd eigenvalues_;
};

}

DrumModes drum_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count)
{
    const Matrices drum = matrices_of(grid, step);
    Subspace modes(drum, 0, static_cast<Eigen::Index>(count));
    modes.find(most_steps, small_residual);
    DrumModes found = modes.found();
    const auto eigenvalues = modes.eigenvalues().head(static_cast<Eigen::Index>(count));
    found.eigenvalues.assign(eigenvalues.begin(), eigenvalues.end());
    return found;
}

/// The number of parts of the region that no element connects.
std::size_t parts_of(const Sparse& stiffness)
{
    std::vector<int> above(static_cast<std::size_t>(stiffness.cols()));
    std::iota(above.begin(), above.end(), 0);
    const auto top = [&](int node) {
        while (above[static_cast<std::size_t>(node)] != node) node = above[static_cast<std::size_t>(node)];
        return node;
    };
    std::size_t parts = above.size();
    for (Eigen::Index column = 0; column < stiffness.outerSize(); ++column)
        for (Sparse::InnerIterator it(stiffness, column); it; ++it) {
            const int a = top(static_cast<int>(it.row())), b = top(static_cast<int>(column));
            if (a == b) continue;
            above[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
            above[static_cast<std::size_t>(it.row())] = above[static_cast<std::size_t>(column)] = std::min(a, b);
            --parts;
        }
    return parts;
}

DrumModes released_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count, double length)
{
    const Matrices drum = matrices_of(grid, step);
    // Each part has a mode of the eigenvalue 0: of more parts than tapers, rounding would choose some.
    if (const std::size_t parts = parts_of(drum.stiffness); parts > count)
        throw InputError(fmt::format("the region has {} parts that are apart from each other: tapers must be at least "
                                     "as many, not {}",
                                     parts, count));
    const Matrices released = released_of(drum);
    Subspace modes(released, std::pow(std::numbers::pi / length, 2), static_cast<Eigen::Index>(count));
    modes.find(most_steps_of_long, small_residual_of_long);
    DrumModes found = modes.found();
    for (const std::vector<double>& values : found.values) {
        const Eigen::Map<const Eigen::VectorXd> mode(values.data(), static_cast<Eigen::Index>(values.size()));
        found.eigenvalues.push_back(mode.dot(drum.stiffness * mode));
    }
    return found;
}

}
