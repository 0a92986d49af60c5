#include "host/large_sets/slab_start.hpp"

#include "base/programs/interrupt.hpp"
#include "host/sampling/baselines.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <algorithm>
#include <string>

namespace poissonlab {
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
