// Equal areas: weights that give all cells of a power diagram the same area, and points that move to the centroids of
// their cells, in turns.
//
// De Goes, Breeden, Ostromoukhov, Desbrun, Blue noise through optimal transport, ACM Transactions on Graphics 31(6),
// 2012: the weights by Newton's method, whose linear equations conjugate gradients solve; steps are halved until no
// cell becomes too small (Kitagawa, Merigot, Thibert 2019). Departures: points move all of the way to their centroids,
// without a line search, and regular parts are not broken up.
#pragma once

#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/optimized/power_cells.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace poissonlab {

/// The cells of a set with weights.
using PowerCellsOf = std::function<PowerCells(const PointSet&, const std::vector<double>& weights)>;

/// Areas are equal when their standard deviation is below this part of their mean. Rounding leaves some 1e-12.
inline constexpr double equal_area_tolerance = 1e-6;

struct EqualAreas
{
    PointSet points;
    std::vector<double> weights;
    std::vector<IterationRecord> iterations;
};

/// Weights for the points, and `iterations` moves with new weights after each. `points` has at least one point, in 2D.
/// The energies of records are the mean squared distance from a place to the point whose cell it is in, in the unit of
/// Lloyd relaxation. Points that coincide stay together, and areas are not equal then.
EqualAreas equalize_areas(const PointSet& points, std::size_t iterations, const PowerCellsOf& cells_of);

/// The sampler "equal-areas": iterations, start.
SamplerSpec equal_areas_sampler();

}
