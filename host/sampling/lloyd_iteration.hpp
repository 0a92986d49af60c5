// The course of the iterations of Lloyd relaxation, which its two engines have in common.
#pragma once

#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/sampling/lloyd_relaxation.hpp"

#include <cmath>
#include <utility>

namespace poissonlab {

/// The measures of an iterate.
struct IterateMeasure
{
    double energy = 0;       ///< as in records
    double squared_near = 0; ///< smallest squared distance of two points
};

/// The energy of a record from the integral over the torus of the squared distance to the nearest point.
inline double lloyd_energy(double integral, std::size_t points, int dimension)
{
    return integral * std::pow(static_cast<double>(points), 2.0 / dimension);
}

/// Runs the iterations of `State`, which has: IterateMeasure measure(), for example of the Voronoi cells; void move(),
/// which moves the points after that; void keep(), which remembers the points as they are; and PointSet kept(), those
/// that were remembered last.
template <typename State>
LloydResult run_iterations(State& state, std::size_t points, int dimension, const LloydRequest& request)
{
    LloydResult result;
    double best = -1;
    for (std::size_t iteration = 0;; ++iteration) {
        stop_if_interrupted();
        const IterateMeasure measure = state.measure();
        const double radius = relative_radius(std::sqrt(measure.squared_near), points, dimension);
        result.iterations.push_back({radius, measure.energy});
        const bool is_last = iteration == request.iterations || radius >= request.until_relative_radius;
        if (request.keep_best ? radius > best : is_last) {
            best = radius;
            result.kept = iteration;
            state.keep();
        }
        if (is_last) break;
        state.move();
    }
    result.points = state.kept();
    return result;
}

}
