// The course of the iterations of Lloyd relaxation, which its two engines have in common.
#pragma once

#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/sampling/lloyd_relaxation.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

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

/// Which iterates are kept, and which is the last one.
class IterationCourse
{
public:
    IterationCourse(std::size_t points, int dimension, const LloydRequest& request)
        : points_(points), dimension_(dimension), request_(request)
    {}

    struct Verdict
    {
        bool is_kept; ///< as far as is known yet
        bool is_last;
    };

    /// Takes the next iterate, the start first.
    Verdict add(const IterateMeasure& measure)
    {
        const std::size_t number = iterations_.size();
        const double radius = relative_radius(std::sqrt(measure.squared_near), points_, dimension_);
        iterations_.push_back({radius, measure.energy});
        const bool is_last = number == request_.iterations || radius >= request_.until_relative_radius;
        const bool is_kept = request_.keep_best ? radius > best_ : is_last;
        if (is_kept) {
            best_ = radius;
            kept_ = number;
        }
        return {is_kept, is_last};
    }

    std::vector<IterationRecord>& iterations() { return iterations_; }
    std::size_t kept() const { return kept_; }

private:
    std::size_t points_;
    int dimension_;
    LloydRequest request_;
    std::vector<IterationRecord> iterations_;
    double best_ = -1;
    std::size_t kept_ = 0;
};

/// Runs the iterations of `State`, which has: IterateMeasure measure(), for example of the Voronoi cells; void move(),
/// which moves the points after that; void keep(), which remembers the points as they are; and PointSet kept(), those
/// that were remembered last.
template <typename State>
LloydResult run_iterations(State& state, std::size_t points, int dimension, const LloydRequest& request)
{
    IterationCourse course(points, dimension, request);
    while (true) {
        stop_if_interrupted();
        const IterationCourse::Verdict now = course.add(state.measure());
        if (now.is_kept) state.keep();
        if (now.is_last) break;
        state.move();
    }
    return {state.kept(), std::move(course.iterations()), course.kept()};
}

}
