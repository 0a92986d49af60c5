// Runs kernels/sector_darts.cl: a work-item for each set, some steps in each call, until all sets are full.
#include "host/sampling/sectors/sector_darts.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace poissonlab {

namespace {

using contract::sector_darts::GrowingSet;
using contract::sector_darts::KeptSector;
using contract::sector_darts::SectorRules;

/// Sets that a work-group has: one, as they have nothing in common.
constexpr std::size_t sets_of_a_group = 1;

constexpr std::size_t most_sets_at_once = 16;
constexpr std::uint64_t usual_sector_memory = std::uint64_t{1} << 29; ///< bytes, unless one set takes more

/// Points, or darts of logarithmic sets, of each set in one call: a call takes a tenth of a second at most.
std::uint32_t steps_of_a_call(SectorVariant variant) { return variant == SectorVariant::boundary ? 4096 : 512; }

}

SectorRules sector_rules(const SectorDartRequest& request)
{
    SectorRules rules{};
    rules.distance = static_cast<std::uint64_t>(std::ceil(request.min_distance * 0x1p32));
    // Rounding a dart to the grid takes less than a unit from its distance.
    rules.reach = static_cast<double>(rules.distance + 1);
    rules.variant = static_cast<std::uint32_t>(request.variant);
    const auto points = static_cast<std::uint64_t>(1 / (request.min_distance * request.min_distance));
    rules.grid_bits = static_cast<std::uint32_t>((std::bit_width(points) - 1) / 2);
    rules.capacity = static_cast<std::uint32_t>(most_sector_darts(request.min_distance));
    if (request.variant == SectorVariant::logarithmic) {
        using namespace contract::sector_darts;
        rules.sectors = std::max<std::uint32_t>(LEAST_SECTORS, SECTORS_PER_POINT * rules.capacity);
        rules.leaves = std::bit_ceil(rules.capacity);
    }
    rules.steps = steps_of_a_call(request.variant);
    return rules;
}

std::size_t most_sector_darts(double min_distance)
{
    return static_cast<std::size_t>(0.92 / (min_distance * min_distance)) + 20; // boundary darts have 0.86
}

struct SectorDartBuffers
{
    Buffer<GrowingSet> sets;
    Buffer<std::array<std::uint32_t, 2>> places;
    Buffer<std::uint32_t> heads, next, open; ///< of cells; in the same cell; points with room, or regions
    Buffer<KeptSector> sectors;
    Buffer<double> areas; ///< of regions, and the sums of the tree

    NeededBuffers needed(const SectorRules& rules, std::size_t count)
    {
        NeededBuffers all{{sets, count},
                          {places, count * rules.capacity},
                          {heads, count << 2 * rules.grid_bits},
                          {next, count * rules.capacity},
                          {open, count * rules.capacity}};
        if (rules.sectors > 0) {
            all.emplace_back(sectors, count * rules.sectors);
            all.emplace_back(areas, count * 3 * rules.leaves);
        }
        return all;
    }
};

SectorDarts::SectorDarts(Device device)
    : DeviceMethod(std::move(device), sets_of_a_group, std::make_shared<SectorDartBuffers>())
{}

std::size_t SectorDarts::sets_at_once(const SectorDartRequest& request)
{
    const std::uint64_t memory = memory_of(SectorDartBuffers{}.needed(sector_rules(request), 1)).total;
    return static_cast<std::size_t>(std::clamp<std::uint64_t>(usual_sector_memory / memory, 1, most_sets_at_once));
}

DeviceMemory SectorDarts::memory(const SectorDartRequest& request)
{
    return memory_of(SectorDartBuffers{}.needed(sector_rules(request), sets_at_once(request)));
}

/// Calls a kernel again and again.
void SectorDarts::grow(const SectorRules& rules, std::vector<GrowingSet>& sets)
{
    using namespace contract::sector_darts;
    SectorDartBuffers& b = *buffers_;
    const bool by_area = rules.variant == LOGARITHMIC;
    Kernel kernel =
        device_.kernel(kernel_program("sector_darts.cl", {}), by_area ? "grow_by_area" : "grow_point_by_point");
    const auto is_growing = [](const GrowingSet& set) { return set.state == GROWING; };
    while (std::ranges::any_of(sets, is_growing)) {
        if (by_area)
            kernel.run(sets.size(), work_group_size_, rules, b.sets, b.places, b.heads, b.next, b.open, b.sectors,
                       b.areas);
        else
            kernel.run(sets.size(), work_group_size_, rules, b.sets, b.places, b.heads, b.next, b.open);
        b.sets.read(sets);
    }
}

std::vector<PointSet> SectorDarts::throw_darts(const SectorDartRequest& request, const std::vector<StreamKey>& streams)
{
    using namespace contract::sector_darts;
    SectorRules rules = sector_rules(request);
    rules.sets = static_cast<std::uint32_t>(streams.size());
    SectorDartBuffers& buffers = *buffers_;
    reserve(device_, buffers.needed(rules, sets_at_once(request)));
    std::vector<GrowingSet> sets(streams.size()); // without points
    for (std::size_t i = 0; i < sets.size(); ++i) {
        sets[i].key_x = streams[i][0];
        sets[i].key_y = streams[i][1];
    }
    buffers.sets.write(sets);
    buffers.heads.write(std::vector<std::uint32_t>(streams.size() << 2 * rules.grid_bits));
    grow(rules, sets);
    std::vector<PointSet> result;
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (sets[i].state == OUT_OF_ROOM) { // for chances that never came: the twin has room for everything
            result.push_back(reference::throw_sector_darts(request, streams[i]));
            continue;
        }
        PointSet& points = result.emplace_back(PointSet{2, {}});
        for (const auto& place : buffers.places.read(i * rules.capacity, sets[i].points))
            for (const std::uint32_t c : place) points.coordinates.push_back(static_cast<double>(c) / UNITS);
    }
    return result;
}

}
