#include "analysis/surfaces/eigenvalue_band.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace poissonlab {
namespace {

using Factor = Eigen::SimplicialLDLT<SparseMatrix>;

/// A block has this many columns: no finite group of symmetries of space forces more eigenvalues to be equal than the
/// five of the icosahedron.
constexpr Eigen::Index block_size = 5;

/// An eigenvalue counts as found if its residual is at most this share of the eigenvalue of the inverse.
constexpr double small_residual = 1e-9;

/// Shifts are tried at these parts of the band, one after another.
constexpr double shifts[] = {0.5, 0.47, 0.55};

/// Returns columns that are orthogonal to no eigenvector: the steps of their sequence grow, so that it follows no order
/// of nodes.
Eigen::MatrixXd start_block(Eigen::Index rows, Eigen::Index first)
{
    Eigen::MatrixXd block(rows, block_size);
    for (Eigen::Index k = 0; k < block_size; ++k)
        for (Eigen::Index i = 0; i < rows; ++i) {
            const double turns = static_cast<double>(i + 1) * static_cast<double>(i + 2) *
                                 std::sqrt(static_cast<double>(first + k) + 2.5);
            block(i, k) = turns - std::floor(turns) - 0.5;
        }
    return block;
}

/// Products take this number of rows at once, so that the part of the basis that is read stays in a cache for all
/// columns of a block.
constexpr Eigen::Index rows_at_once = 128;

/// Calls `take(first, count)` for blocks of rows, until all rows were taken.
template <typename Take>
void for_rows(Eigen::Index rows, const Take& take)
{
    for (Eigen::Index first = 0; first < rows; first += rows_at_once) take(first, std::min(rows_at_once, rows - first));
}

/// Returns basis^T block, column by column: products of matrices would copy the basis, which takes longer than the
/// product with so few columns.
Eigen::MatrixXd shares_of(Eigen::Ref<const Eigen::MatrixXd> basis, const Eigen::MatrixXd& block)
{
    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(basis.cols(), block.cols());
    for_rows(basis.rows(), [&](Eigen::Index first, Eigen::Index count) {
        for (Eigen::Index k = 0; k < block.cols(); ++k)
            shares.col(k).noalias() += basis.middleRows(first, count).transpose() * block.col(k).segment(first, count);
    });
    return shares;
}

/// Subtracts basis shares from a block, column by column.
void subtract(Eigen::Ref<const Eigen::MatrixXd> basis, const Eigen::MatrixXd& shares, Eigen::MatrixXd& block)
{
    for_rows(basis.rows(), [&](Eigen::Index first, Eigen::Index count) {
        for (Eigen::Index k = 0; k < block.cols(); ++k)
            block.col(k).segment(first, count).noalias() -= basis.middleRows(first, count) * shares.col(k);
    });
}

/// Returns what the inverse of the factored matrix makes of a block. Its rows stand side by side, each filled up to
/// whole pairs, so that each number of the factor is read once for all columns. Each column's sums are those of
/// Factor::solve().
Eigen::MatrixXd solved(const Factor& factor, const Eigen::MatrixXd& block)
{
    constexpr Eigen::Index width = (block_size + 1) / 2 * 2;
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, width, Eigen::RowMajor>;
    Rows rows = Rows::Zero(block.rows(), width);
    rows.leftCols(block_size) = factor.permutationP() * block;
    const SparseMatrix& lower = factor.matrixL().nestedExpression(); // without its diagonal of ones
    const auto row = [&](Eigen::Index i) { return std::span<double, width>(rows.data() + i * width, width); };
    for (Eigen::Index j = 0; j < lower.cols(); ++j) {
        std::array<double, width> from;
        std::ranges::copy(row(j), from.begin());
        for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
            for (Eigen::Index k = 0; k < width; ++k) row(entry.index())[k] -= from[k] * entry.value();
    }
    rows = factor.vectorD().asDiagonal().inverse() * rows;
    for (Eigen::Index j = lower.cols() - 1; j >= 0; --j) {
        std::array<double, width> sums;
        std::ranges::copy(row(j), sums.begin());
        for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
            for (Eigen::Index k = 0; k < width; ++k) sums[k] -= entry.value() * row(entry.index())[k];
        std::ranges::copy(sums, row(j).begin());
    }
    return factor.permutationPinv() * rows.leftCols(block_size);
}

/// A basis that grows by what the inverse of stiffness - shift mass makes of its last block.
class LanczosBasis
{
public:
    LanczosBasis(const Pencil& pencil, double shift, Eigen::Index most)
        : mass_(pencil.mass), inverse_(pencil.stiffness - shift * pencil.mass), shift_(shift),
          basis_(mass_.rows(), most + block_size),
          projected_(Eigen::MatrixXd::Zero(most + block_size, most + block_size))
    {
        if (is_ready()) append(start_block(mass_.rows(), 0));
    }

    bool is_ready() const { return inverse_.info() == Eigen::Success; }
    Eigen::Index size() const { return size_; }
    Eigen::Index room() const { return basis_.cols() - block_size - size_; }

    /// Adds a block.
    void grow()
    {
        stop_if_interrupted();
        const Eigen::Index begin = size_ - block_size;
        append(solved(inverse_, mass_ * basis_.middleCols(begin, block_size)));
    }

    /// Returns the eigenvectors found so far from `low` to `high`. The last block serves to measure residuals only.
    EigenvalueBand found(double low, double high) const
    {
        const Eigen::Index inner = size_ - block_size;
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(projected_.topLeftCorner(inner, inner));
        const Eigen::MatrixXd rest = projected_.block(inner, inner - block_size, block_size, block_size) *
                                     ritz.eigenvectors().bottomRows(block_size);
        std::vector<std::pair<double, Eigen::Index>> good;
        for (Eigen::Index i = 0; i < inner; ++i) {
            const double of_inverse = ritz.eigenvalues()[i], eigenvalue = shift_ + 1 / of_inverse;
            if (eigenvalue >= low && eigenvalue < high && rest.col(i).norm() <= small_residual * std::abs(of_inverse))
                good.emplace_back(eigenvalue, i);
        }
        std::ranges::sort(good);
        const auto count = static_cast<Eigen::Index>(good.size());
        EigenvalueBand band{Eigen::VectorXd(count), {}};
        Eigen::MatrixXd chosen(inner, count);
        for (Eigen::Index k = 0; k < count; ++k) {
            band.eigenvalues[k] = good[static_cast<std::size_t>(k)].first;
            chosen.col(k) = ritz.eigenvectors().col(good[static_cast<std::size_t>(k)].second);
        }
        band.vectors = basis_.leftCols(inner) * chosen;
        return band;
    }

private:
    /// Makes a block orthonormal, in itself and to the basis, in two passes, and adds it. The coefficients go into the
    /// projection of the inverse. Without rounding, a new block would overlap only the last two blocks: the first pass
    /// removes that overlap, and the second one removes the overlap with all blocks that rounding has left.
    void append(Eigen::MatrixXd block)
    {
        Eigen::MatrixXd of_last = Eigen::MatrixXd::Zero(std::min(size_, block_size), block_size),
                        of_itself = Eigen::MatrixXd::Identity(block_size, block_size);
        Eigen::Index shared = std::min(size_, 2 * block_size);
        bool is_replaced = false;
        for (int passes = 2; passes > 0; --passes, shared = size_) {
            const auto basis = basis_.middleCols(size_ - shared, shared);
            const Eigen::MatrixXd shares = shares_of(basis, mass_ * block);
            subtract(basis, shares, block);
            of_last += shares.bottomRows(of_last.rows()) * of_itself;
            const Eigen::LLT<Eigen::MatrixXd> root(block.transpose() * (mass_ * block));
            const Eigen::MatrixXd upper = root.matrixU();
            if (root.info() != Eigen::Success || !(upper.diagonal().minCoeff() > 0)) { // nothing new is left
                block = start_block(mass_.rows(), size_);
                of_itself.setZero();
                if (!is_replaced) passes = 3; // two passes with all blocks follow
                is_replaced = true;
                continue;
            }
            root.matrixU().solveInPlace<Eigen::OnTheRight>(block);
            of_itself = upper * of_itself;
        }
        basis_.middleCols(size_, block_size) = block;
        if (size_ > 0) {
            const Eigen::Index begin = size_ - block_size;
            projected_.block(begin, begin, block_size, block_size) = of_last;
            projected_.block(size_, begin, block_size, block_size) = of_itself;
        }
        size_ += block_size;
    }

    const SparseMatrix& mass_;
    Factor inverse_;
    double shift_;
    Eigen::MatrixXd basis_;     ///< its first columns
    Eigen::MatrixXd projected_; ///< the lower half; the upper one is its mirror image
    Eigen::Index size_ = 0;
};

}

std::size_t eigenvalues_below(const Pencil& pencil, double value)
{
    stop_if_interrupted();
    const Factor factor(pencil.stiffness - value * pencil.mass);
    if (factor.info() != Eigen::Success)
        throw InputError(fmt::format("the mesh's eigenfunctions below the eigenvalue {:.6g} cannot be counted", value));
    return static_cast<std::size_t>((factor.vectorD().array() < 0).count());
}

std::size_t most_basis_size(std::size_t count) { return 6 * count + 20 * static_cast<std::size_t>(block_size); }

EigenvalueBand eigenvalues_between(const Pencil& pencil, double low, double high, std::size_t count)
{
    const auto wanted = static_cast<Eigen::Index>(count);
    const Eigen::Index most =
        std::min(pencil.mass.rows() - 2 * block_size, static_cast<Eigen::Index>(most_basis_size(count)));
    std::size_t best = 0;
    for (const double part : shifts) {
        LanczosBasis basis(pencil, low + part * (high - low), most);
        for (Eigen::Index next = 3 * wanted + 2 * block_size; basis.is_ready() && basis.room() >= 0;
             next = basis.size() + std::max<Eigen::Index>(2 * block_size, wanted / 4)) {
            while (basis.size() < next && basis.room() >= 0) basis.grow();
            EigenvalueBand band = basis.found(low, high);
            if (band.eigenvalues.size() == wanted) return band;
            best = std::max(best, static_cast<std::size_t>(band.eigenvalues.size()));
        }
    }
    throw InputError(
        fmt::format("of {} eigenfunctions with eigenvalues from {:.6g} to {:.6g} only {} could be found: the "
                    "mesh may have triangles far thinner than others",
                    count, low, high, best));
}

EigenvalueBand eigenvalues_of_small(const Pencil& pencil, double low, double high)
{
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> all{Eigen::MatrixXd(pencil.stiffness),
                                                                        Eigen::MatrixXd(pencil.mass)};
    const auto below = [&](double value) { return (all.eigenvalues().array() < value).count(); };
    const Eigen::Index begin = below(low), count = below(high) - begin;
    return {all.eigenvalues().segment(begin, count), all.eigenvectors().middleCols(begin, count)};
}

}
