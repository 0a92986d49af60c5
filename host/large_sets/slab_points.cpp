#include "host/large_sets/slab_points.hpp"

namespace poissonlab {

SlabPoints::SlabPoints(const SlabDivision& division, Crew& crew, std::uint64_t expected)
    : division_(division), crew_(crew),
      first_slab_(division.slabs() / static_cast<std::uint32_t>(crew.size()) * static_cast<std::uint32_t>(crew.rank())),
      own_(division.slabs() / static_cast<std::uint32_t>(crew.size())), around_(own_.size()), outbox_(crew)
{
    for (std::uint32_t slab = first_slab_; slab < end_slab(); ++slab) {
        const std::uint64_t layers = division.first_layer(slab + 1) - division.first_layer(slab);
        const std::uint64_t points = expected * layers / division.layers();
        own_[slab - first_slab_].coordinates.reserve((points + points / 64) *
                                                     static_cast<std::size_t>(division.dimension()));
        own_[slab - first_slab_].ids.reserve(points + points / 64);
    }
}

void SlabPoints::put(std::span<const double> place, std::uint32_t id)
{
    const std::uint32_t slab = division_.slab_of(place.back());
    if (is_here(slab))
        own_[slab - first_slab_].add(place, id);
    else
        outbox_.add(process_of(slab), place, id, slab);
}

bool SlabPoints::settle()
{
    const auto axes = static_cast<std::size_t>(division_.dimension());
    return outbox_.send(crew_, [&](const SentPoint& point) {
        own_[point.slab - first_slab_].add(std::span(point.place).first(axes), point.id);
    });
}

bool SlabPoints::fetch_around(std::uint32_t layers)
{
    const auto axes = static_cast<std::size_t>(division_.dimension());
    const auto slabs_around = division_.slabs_around_layers(layers);
    const bool is_collected = crew_.together([&] {
        for (NumberedPoints& points : around_) points.clear();
        for (const NumberedPoints& points : own_)
            for (std::size_t i = 0; i < points.size(); ++i) {
                const std::span place = std::span(points.coordinates).subspan(i * axes, axes);
                for (const std::uint32_t slab : slabs_around[division_.layer_of(place.back())])
                    if (is_here(slab))
                        around_[slab - first_slab_].add(place, points.ids[i]);
                    else
                        outbox_.add(process_of(slab), place, points.ids[i], slab);
            }
    });
    return is_collected && outbox_.send(crew_, [&](const SentPoint& point) {
        around_[point.slab - first_slab_].add(std::span(point.place).first(axes), point.id);
    });
}

void SlabPoints::clear()
{
    for (NumberedPoints& points : own_) points.clear();
    for (NumberedPoints& points : around_) points.clear();
}

}
