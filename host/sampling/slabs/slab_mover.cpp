#include "host/sampling/slabs/slab_mover.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Moves points as kernels/relaxation.cl does, so that bytes are the same.
void move_all(std::span<double> coordinates, std::span<const double> displacements)
{
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const double moved = coordinates[i] + displacements[i];
        const double wrapped = moved - std::floor(moved);
        coordinates[i] = wrapped < 1 ? wrapped : 0; // just below 0, the sum rounds to 1
    }
}

}

void SlabMover::make_room(const GridPart& part, std::size_t points)
{
    if (grid_ && points <= room_ && part.held <= largest_.held) return;
    grid_.reset();
    room_ = std::max(room_, with_slack(points));
    if (part.held > largest_.held) largest_ = part;
    check_fits(fmt::format("a slab with {} points", points), memory(*method_, dimension_, points, part),
               device_.info());
    method_->make_room(device_, room_);
    grid_.emplace(device_, dimension_, room_, largest_, default_work_group_size);
}

const SlabMover::Moved* SlabMover::move(const GridPart& part, const NumberedPoints& own, const NumberedPoints& around)
{
    make_room(part, own.size() + around.size());
    grid_->clear(part);
    grid_->add(own.coordinates, own.ids);
    grid_->add(around.coordinates, around.ids);
    grid_->sort();
    method_->find(*grid_);
    if (!method_->is_known()) return nullptr;

    const auto axes = static_cast<std::size_t>(dimension_);
    const std::size_t first = grid_->own_points().first;
    moved_.points.ids.resize(own.size());
    grid_->ids().read(std::span(moved_.points.ids), first);
    read_.resize(own.size());
    method_->squared_near().read(std::span(read_), first);
    moved_.squared_near = std::ranges::min(read_);
    moved_.points.coordinates.resize(own.size() * axes);
    grid_->positions().read(std::span(moved_.points.coordinates), first * axes);
    read_.resize(own.size() * axes);
    method_->displacements().read(std::span(read_), first * axes);
    move_all(moved_.points.coordinates, read_);
    return &moved_;
}

std::vector<std::vector<std::uint32_t>> SlabDivision::slabs_around_layers(std::uint32_t around) const
{
    std::vector<std::vector<std::uint32_t>> slabs_of(cells_per_axis_);
    for (std::uint32_t slab = 0; slab < slabs_; ++slab) {
        const std::uint32_t first = first_layer(slab);
        const std::uint32_t end = first_layer(slab + 1);
        if (first == end) continue;
        const std::uint64_t others =
            std::min<std::uint64_t>(cells_per_axis_ - (end - first), std::uint64_t{2} * around);
        // Layers behind the slab come first, then, around the torus, layers before it.
        const std::uint64_t behind = std::min<std::uint64_t>(others, around);
        for (std::uint64_t i = 0; i < others; ++i) {
            const std::uint64_t layer = i < behind ? end + i : first + cells_per_axis_ - 1 - (i - behind);
            slabs_of[layer % cells_per_axis_].push_back(slab);
        }
    }
    return slabs_of;
}

}
