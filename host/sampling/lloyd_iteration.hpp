// The course of the iterations of Lloyd relaxation, which its two engines have in common.
#pragma once

#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/sampling/lloyd_relaxation.hpp"

#include <algorithm>
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

/// Iterations that are enqueued before the host looks at their measures, at most: many where one takes less than
/// waiting for it, and few enough for an interruption to be seen soon.
inline std::size_t iterations_of_batch(std::size_t points, int dimension)
{
    constexpr std::size_t most = 64;
    const std::size_t points_of_batch = std::size_t{1} << (dimension == 2 ? 18 : 15);
    return std::clamp<std::size_t>(points_of_batch / std::max<std::size_t>(points, 1), 1, most);
}

/// Iterates of the next batch after those that were made, the start among them. Batches are short in the beginning:
/// what is made in vain is a part of all then, and the first iterates of crowded points take long.
inline std::size_t next_batch(std::size_t points, int dimension, std::size_t made, std::size_t iterations)
{
    return std::min({iterations_of_batch(points, dimension), iterations + 1 - made, 1 + made / 4});
}

/// Runs the iterations of `State` by batches. The state has: void measure_later(), which enqueues the measures of the
/// points as they are; void move(), which enqueues their movement after that; std::vector<IterateMeasure> measures(),
/// which waits for those that were enqueued; PointSet points(); and void load(points), after which iterations go as
/// from the start.
///
/// Where an iterate within a batch turns out to be the one to keep, its points are made once more, from those that the
/// batch began with. `work` is a number of points whose Lloyd iterations take as long, not below `points`: batches are
/// as long as theirs.
template <typename State>
LloydResult run_batches(State& state, std::size_t points, std::size_t work, int dimension, const LloydRequest& request)
{
    IterationCourse course(points, dimension, request);
    const bool may_go_back = request.keep_best || request.until_relative_radius <= 1;
    PointSet kept;
    std::size_t moves_to_kept = 0;
    for (bool is_last = false; !is_last;) {
        stop_if_interrupted();
        const std::size_t made = course.iterations().size();
        if (made > 0) state.move();
        const std::size_t count = next_batch(work, dimension, made, request.iterations);
        const PointSet before = may_go_back && count > 1 ? state.points() : PointSet{};
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) state.move();
            state.measure_later();
        }
        const std::vector<IterateMeasure> measures = state.measures();
        for (std::size_t i = 0; i < count && !is_last; ++i) {
            const IterationCourse::Verdict now = course.add(measures[i]);
            is_last = now.is_last;
            if (!now.is_kept) continue;
            moves_to_kept = i + 1 < count ? i : 0;
            kept = i + 1 < count ? before : state.points();
        }
    }
    if (moves_to_kept > 0) {
        state.load(kept);
        for (std::size_t i = 0; i < moves_to_kept; ++i) {
            state.measure_later();
            state.move();
        }
        state.measures();
        kept = state.points();
    }
    return {std::move(kept), std::move(course.iterations()), course.kept()};
}

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
