#include "host/isohedral_tiling/tile_finder.hpp"

#include "base/errors/errors.hpp"

namespace poissonlab {
namespace {

static_assert(contract::tile_finder::LATTICE_BITS() == lattice_bits);

contract::tile_finder::Candidate stored_candidate(const LookupCandidate& c)
{
    return {.aspect = static_cast<std::int32_t>(c.place.aspect),
            .column = c.place.column,
            .row = c.place.row,
            .first = static_cast<std::int32_t>(c.first),
            .count = static_cast<std::int32_t>(c.count),
            .low_x = c.low[0],
            .low_y = c.low[1],
            .high_x = c.high[0],
            .high_y = c.high[1],
            .anchor_x = c.anchor[0],
            .anchor_y = c.anchor[1]};
}

}

NeededBuffers TileFinder::Buffers::needed(std::size_t points_count, const TileLookup& lookup)
{
    return {{points, 2 * points_count},
            {candidates, lookup.candidates.size()},
            {corners, 2 * lookup.corners.size()},
            {found, points_count}};
}

TileFinder::TileFinder(Device device, const TileLookup& lookup, std::size_t work_group_size)
    : device_(std::move(device)), lookup_(lookup),
      work_group_size_(work_group_size == 0 ? default_work_group_size : work_group_size),
      find_tiles_(device_.kernel(kernel_program("tile_finder.cl", {}), "find_tiles"))
{
    reserve(device_, buffers_.needed(0, lookup_));
    std::vector<contract::tile_finder::Candidate> candidates;
    for (const LookupCandidate& candidate : lookup_.candidates) candidates.push_back(stored_candidate(candidate));
    std::vector<std::int32_t> corners;
    for (const auto& corner : lookup_.corners) corners.insert(corners.end(), corner.begin(), corner.end());
    buffers_.candidates.write(candidates);
    buffers_.corners.write(corners);
}

DeviceMemory TileFinder::memory(std::size_t points) { return memory_of(Buffers{}.needed(points, lookup_)); }

std::vector<FoundTile> TileFinder::find(std::span<const LatticePoint> points)
{
    if (points.size() >= std::size_t{1} << 31) throw InputError("2^31 places or more are too many at once");
    reserve(device_, buffers_.points, 2 * points.size());
    reserve(device_, buffers_.found, points.size());
    std::vector<std::int64_t> coordinates;
    coordinates.reserve(2 * points.size());
    for (const LatticePoint& point : points) coordinates.insert(coordinates.end(), point.begin(), point.end());
    buffers_.points.write(coordinates);
    const auto count = static_cast<std::uint32_t>(points.size());
    const auto candidates = static_cast<std::uint32_t>(lookup_.candidates.size());
    find_tiles_.run(points.size(), work_group_size_, count, candidates, buffers_.points, buffers_.candidates,
                    buffers_.corners, buffers_.found);
    std::vector<FoundTile> tiles;
    tiles.reserve(points.size());
    for (const auto& f : buffers_.found.read(0, points.size()))
        tiles.push_back({{static_cast<std::uint32_t>(f.aspect), f.column, f.row}, {f.x, f.y}});
    return tiles;
}

}
