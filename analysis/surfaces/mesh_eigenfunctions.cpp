#include "analysis/surfaces/mesh_eigenfunctions.hpp"

#include "analysis/surfaces/eigenvalue_band.hpp"
#include "analysis/surfaces/refined_mesh.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/memory_limit.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

namespace poissonlab {
namespace {

using Triplets = std::vector<Eigen::Triplet<double, int>>;

/// Meshes of up to this number of vertices are small: all of their eigenvectors take little time.
constexpr Eigen::Index few_vertices = 300;

/// A band has about this number of eigenfunctions, by Weyl's law.
constexpr double of_a_band = 60;

/// Eigenvalues below this part of Weyl's first one are those of constant functions.
constexpr double nearly_none = 1e-6;

SparseMatrix matrix_of(const Triplets& entries, std::size_t vertices)
{
    const auto size = static_cast<Eigen::Index>(vertices);
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// Returns the matrices of linear elements. The stiffness of two corners is the dot product of the edges opposite to
/// them over four times the area, which is half the negative cotangent of the third angle.
Pencil pencil_of(const TriangleMesh& mesh)
{
    Triplets stiffness, mass;
    for (const MeshTriangle& t : mesh.triangles) {
        const double area = area_of(mesh, t);
        std::array<MeshPoint, 3> facing;
        for (std::size_t k = 0; k < 3; ++k)
            facing[k] = difference(mesh.vertices[t[(k + 2) % 3]], mesh.vertices[t[(k + 1) % 3]]);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j) {
                const int row = static_cast<int>(t[i]), column = static_cast<int>(t[j]);
                stiffness.emplace_back(row, column, dot(facing[i], facing[j]) / (4 * area));
                // the full mass has a sixth and a twelfth of the area, the lumped one a third on the diagonal
                mass.emplace_back(row, column, i == j ? area / 4 : area / 24);
            }
    }
    return {matrix_of(stiffness, mesh.vertices.size()), matrix_of(mass, mesh.vertices.size())};
}

/// Returns the integrals of the squares of functions whose norm is 1 by the mean of the two masses. The rows of all
/// three masses have the same sums, which are the lumped mass.
Eigen::VectorXd squares_of(const Eigen::MatrixXd& vectors, const Eigen::VectorXd& lumped)
{
    return 2 - (vectors.array().square().colwise() * lumped.array()).colwise().sum().transpose();
}

/// Returns the load of a set of points at each vertex, scaled such that the square of its product with an eigenfunction
/// is the power.
Eigen::VectorXd load_of(const TriangleMesh& mesh, const std::vector<MeshPosition>& set, double area)
{
    Eigen::VectorXd load = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.vertices.size()));
    for (const MeshPosition& position : set)
        for (std::size_t k = 0; k < 3; ++k)
            load[static_cast<Eigen::Index>(mesh.triangles[position.triangle][k])] += position.shares[k];
    return load * std::sqrt(area / static_cast<double>(set.size()));
}

/// Finds the powers of sets on one mesh, band by band.
class MeshSpectrum
{
public:
    MeshSpectrum(const TriangleMesh& mesh, double highest, const std::vector<std::vector<MeshPosition>>& sets)
        : pencil_(pencil_of(mesh)), lumped_(pencil_.mass * Eigen::VectorXd::Ones(pencil_.mass.cols())),
          loads_(pencil_.mass.rows(), static_cast<Eigen::Index>(sets.size()))
    {
        const double area = lumped_.sum(), low = nearly_none * eigenvalue_of(frequency_of_eigenfunctions(1, area));
        for (std::size_t s = 0; s < sets.size(); ++s)
            loads_.col(static_cast<Eigen::Index>(s)) = load_of(mesh, sets[s], area);
        const double eigenfunctions = eigenfunctions_up_to(frequency_of(highest), area);
        const auto bands =
            is_small() ? 1 : std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(eigenfunctions / of_a_band)));
        for (std::size_t k = 0; k <= bands; ++k)
            borders_.push_back(low + (highest - low) * static_cast<double>(k) / static_cast<double>(bands));
    }

    EigenfunctionPowers powers(const EigenfunctionProgress& on_progress) const
    {
        std::vector<EigenfunctionPowers> of_bands(borders_.size() - 1);
        std::vector<std::size_t> below(borders_.size());
        if (!is_small())
            tbb::parallel_for(std::size_t{0}, below.size(),
                              [&](std::size_t k) { below[k] = eigenvalues_below(pencil_, borders_[k]); });
        if (!std::ranges::is_sorted(below)) // rounding errors are larger than the smallest pivots
            throw InputError("the mesh's eigenfunctions cannot be counted: it has triangles far thinner than others");
        std::mutex telling;
        std::size_t done = 0;
        tbb::parallel_for(std::size_t{0}, of_bands.size(), [&](std::size_t k) {
            of_bands[k] = powers_in(borders_[k], borders_[k + 1], below[k + 1] - below[k]);
            const std::lock_guard lock(telling);
            done += of_bands[k].eigenvalues.size();
            if (on_progress) on_progress(done, is_small() ? done : below.back() - below.front());
        });
        EigenfunctionPowers all;
        all.powers.resize(static_cast<std::size_t>(loads_.cols()));
        for (const EigenfunctionPowers& band : of_bands) {
            all.eigenvalues.insert(all.eigenvalues.end(), band.eigenvalues.begin(), band.eigenvalues.end());
            for (std::size_t s = 0; s < all.powers.size(); ++s)
                all.powers[s].insert(all.powers[s].end(), band.powers[s].begin(), band.powers[s].end());
        }
        return all;
    }

private:
    bool is_small() const { return pencil_.mass.rows() <= few_vertices; }

    EigenfunctionPowers powers_in(double low, double high, std::size_t count) const
    {
        EigenfunctionPowers found;
        found.powers.resize(static_cast<std::size_t>(loads_.cols()));
        if (count == 0 && !is_small()) return found;
        const EigenvalueBand band =
            is_small() ? eigenvalues_of_small(pencil_, low, high) : eigenvalues_between(pencil_, low, high, count);
        found.eigenvalues.assign(band.eigenvalues.begin(), band.eigenvalues.end());
        const Eigen::VectorXd squares = squares_of(band.vectors, lumped_);
        for (Eigen::Index s = 0; s < loads_.cols(); ++s) {
            const Eigen::VectorXd sums = band.vectors.transpose() * loads_.col(s);
            const Eigen::VectorXd of_set = sums.array().square() / squares.array();
            found.powers[static_cast<std::size_t>(s)].assign(of_set.begin(), of_set.end());
        }
        return found;
    }

    Pencil pencil_;
    Eigen::VectorXd lumped_;
    Eigen::MatrixXd loads_; ///< a column each set
    std::vector<double> borders_;
};

}

EigenfunctionPowers eigenfunction_powers(const TriangleMesh& mesh, double highest,
                                         const std::vector<std::vector<MeshPosition>>& sets,
                                         const EigenfunctionProgress& on_progress)
{
    return MeshSpectrum(mesh, highest, sets).powers(on_progress);
}

void check_room_for_eigenfunctions(double vertices)
{
    const double columns = static_cast<double>(most_basis_size(static_cast<std::size_t>(of_a_band))),
                 threads = tbb::this_task_arena::max_concurrency(), bytes = 8 * columns * threads * vertices;
    constexpr double gibibyte = 1 << 30;
    if (const auto most = static_cast<double>(memory_limit()); bytes > most)
        throw InputError(fmt::format("the eigenfunctions of {:.3g} vertices need {:.1f} GiB of memory: must be at most "
                                     "{:.1f}; fewer eigenfunctions need fewer vertices",
                                     vertices, bytes / gibibyte, most / gibibyte));
}

double eigenfunctions_up_to(double frequency, double area) { return std::numbers::pi * area * frequency * frequency; }

double frequency_of_eigenfunctions(double count, double area) { return std::sqrt(count / (std::numbers::pi * area)); }

double eigenvalue_of(double frequency) { return 4 * std::numbers::pi * std::numbers::pi * frequency * frequency; }

double frequency_of(double eigenvalue) { return std::sqrt(eigenvalue) / (2 * std::numbers::pi); }

}
