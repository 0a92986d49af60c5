// Power of several sets of points in the plane, each alone and all together, and of pairs of them.
//
// With F_a(f) = sum_j exp(-2 pi i f.x_j) over the N_a points of set a, the power of a set is |F_a|^2 / N_a as in
// spectrum.hpp, and the cross power of two is Re(F_a conj(F_b)) / sqrt(N_a N_b): 0 on average for sets that know
// nothing of each other, negative where one has its points between those of the other.
#pragma once

#include "analysis/spectra/nonuniform_transform.hpp"
#include "base/geometry/point_set.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// Radial means; value k of each list is of frequencies f with round(|f|) = k + 1.
struct CrossSpectra
{
    std::vector<std::vector<double>> power; ///< of each set, then of all points
    std::vector<std::vector<double>> cross; ///< of pairs (0, 1), (0, 2), (1, 2), (0, 3), ...

    std::size_t bins() const { return power.empty() ? 0 : power.front().size(); }
};

/// The spectra of sets in 2D, none of them empty, up to frequency `reach`.
CrossSpectra cross_spectra(const std::vector<PointSet>& sets, int reach);

/// Returns the spectra of sets of `counts` points whose transforms F_a are `planes`, which have equal reach.
CrossSpectra spectra_of_planes(const std::vector<HalfPlane>& planes, const std::vector<double>& counts);

}
