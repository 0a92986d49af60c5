#include "host/large_sets/slab_relaxation.hpp"

#include "base/programs/interrupt.hpp"
#include "host/sampling/baselines.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <string>
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

namespace {

/// Points that a process makes and sends at a time.
constexpr std::uint64_t points_a_turn = std::uint64_t{1} << 18;

}

bool SlabStart::make()
{
    points_ = request_.points;
    if (shares()) return true;
    const bool is_made = crew_.together([&] {
        if (!crew_.leads()) return;
        set_ = choice_.spec->create(choice_.parameters, request_, place_.engine, place_.device)->sample(0);
        points_ = set_.size();
    });
    if (is_made) points_ = std::stoull(crew_.from_leader(std::to_string(points_)));
    return is_made;
}

std::vector<double> SlabStart::piece(std::uint64_t first, std::uint64_t end) const
{
    if (shares())
        return random_points_from(first, static_cast<std::size_t>(end - first), request_.dimension, request_.seed, 0);
    const auto axes = static_cast<std::uint64_t>(request_.dimension);
    const double* const all = set_.coordinates.data();
    return {all + first * axes, all + end * axes};
}

bool SlabStart::put_into(SlabPoints& slabs)
{
    const auto axes = static_cast<std::size_t>(request_.dimension);
    const std::uint64_t makers = shares() ? static_cast<std::uint64_t>(crew_.size()) : 1;
    const auto rank = static_cast<std::uint64_t>(crew_.rank());
    for (std::uint64_t turn = 0; turn < points_; turn += makers * points_a_turn) {
        const bool is_put = crew_.together([&] {
            stop_if_interrupted();
            if (rank >= makers) return;
            const std::uint64_t first = std::min(points_, turn + rank * points_a_turn);
            const std::vector<double> coordinates = piece(first, std::min(points_, first + points_a_turn));
            for (std::size_t i = 0; i * axes < coordinates.size(); ++i)
                slabs.put(std::span(coordinates).subspan(i * axes, axes), static_cast<std::uint32_t>(first + i));
        });
        if (!is_put || !slabs.settle()) return false;
    }
    set_ = {};
    return true;
}

bool put_parts(const SlabPoints& coarse, std::uint64_t coarse_points, SlabPoints& fine, std::uint64_t points,
               int dimension, Crew& crew)
{
    const auto axes = static_cast<std::size_t>(dimension);
    const auto put_corner = [&](std::size_t corner, const NumberedPoints& own) {
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::uint64_t id = corner * coarse_points + own.ids[i];
            if (id >= points) continue;
            const auto part = split_place(std::span(own.coordinates).subspan(i * axes, axes), corner, coarse_points);
            fine.put(std::span(part).first(axes), static_cast<std::uint32_t>(id));
        }
    };
    for (std::size_t corner = 0; corner >> axes == 0; ++corner) {
        const bool is_put = crew.together([&] {
            stop_if_interrupted();
            for (std::uint32_t slab = coarse.first_slab(); slab < coarse.end_slab(); ++slab)
                put_corner(corner, coarse.own(slab));
        });
        if (!is_put || !fine.settle()) return false;
    }
    return true;
}

}
