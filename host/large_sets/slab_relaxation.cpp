#include "host/large_sets/slab_relaxation.hpp"

#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace poissonlab {

SlabRelaxation::SlabRelaxation(Device device, int dimension, std::uint64_t points, std::unique_ptr<SlabMethod> method,
                               std::uint32_t slabs, Crew& crew)
    : dimension_(dimension), count_(points), mover_(std::move(device), dimension, std::move(method)),
      division_(mover_.method().cells_per_axis(), dimension, slabs * static_cast<std::uint32_t>(crew.size())),
      crew_(crew), around_(mover_.method().layers_around()),
      points_(std::make_unique<SlabPoints>(division_, crew, points)),
      moved_(std::make_unique<SlabPoints>(division_, crew, points))
{}

/// The least of what all processes have; 0 or more.
double SlabRelaxation::least_of_all(double value)
{
    std::vector<std::uint64_t> bits(static_cast<std::size_t>(crew_.size()));
    bits[static_cast<std::size_t>(crew_.rank())] = std::bit_cast<std::uint64_t>(value);
    return std::bit_cast<double>(std::ranges::min(crew_.sum(bits))); // bits are in the order of the numbers
}

bool SlabRelaxation::move_slabs(bool& is_known, double& squared_near)
{
    const auto axes = static_cast<std::size_t>(dimension_);
    return crew_.together([&] {
        moved_->clear();
        for (std::uint32_t slab = points_->first_slab(); slab < points_->end_slab() && is_known; ++slab) {
            stop_if_interrupted();
            if (points_->own(slab).size() == 0) continue;
            const SlabMover::Moved* step =
                mover_.move(division_.part(slab, around_), points_->own(slab), points_->around(slab));
            is_known = step != nullptr;
            if (!is_known) break;
            squared_near = std::min(squared_near, step->squared_near);
            for (std::size_t i = 0; i < step->points.size(); ++i)
                moved_->put(std::span(step->points.coordinates).subspan(i * axes, axes), step->points.ids[i]);
        }
    });
}

/// Fills `moved_` and `squared_near_`.
bool SlabRelaxation::make_step()
{
    for (;; around_ *= 2) {
        bool is_known = true;
        double squared_near = std::numeric_limits<double>::infinity();
        if (!points_->fetch_around(around_) || !move_slabs(is_known, squared_near)) return false;
        const std::uint64_t unknown = crew_.sum({is_known ? 0u : 1u}).front();
        if (!moved_->settle()) return false;
        if (unknown > 0) continue;
        squared_near_ = least_of_all(squared_near);
        return true;
    }
}

bool SlabRelaxation::run(const LloydRequest& request, const OnIteration& on_iteration)
{
    IterationCourse course(count_, dimension_, request);
    std::optional<SlabPoints> best;
    for (;;) {
        if (!make_step()) return false;
        const auto now = course.add({0, squared_near_});
        const bool is_noted = crew_.together([&] {
            on_iteration(course.iterations().size() - 1, course.iterations().back().relative_radius);
            if (now.is_kept && request.keep_best) best.emplace(*points_);
        });
        if (!is_noted) return false;
        if (now.is_last) break;
        std::swap(points_, moved_);
    }
    kept_ = course.kept();
    relative_radius_ = course.iterations()[kept_].relative_radius;
    if (best) points_ = std::make_unique<SlabPoints>(std::move(*best));
    moved_.reset();
    return true;
}

}
