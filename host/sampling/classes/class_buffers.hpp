// The buffers of kernels/class_darts.cl.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/region_buffers.hpp"
#include "host/sampling/classes/class_cells.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace poissonlab {

struct ClassDartBuffers
{
    using Words = Buffer<std::uint32_t>;

    Buffer<contract::class_darts::ClassPair> pairs;
    Buffer<contract::class_darts::ClassGrid> grids;
    Buffer<contract::class_darts::ClassCells> lists;
    Words cells, starts, kept;                      ///< those of all lists; bits of the list that is refined
    Buffer<contract::class_darts::ClassSlot> slots; ///< those of the batch
    Words candidates, heads, points, counters;
    Buffer<contract::class_darts::CoveredCells> covered_cells;
    Words covered;
    RegionBuffers region;
};

/// Slots of a batch at most.
inline constexpr std::size_t most_slots = 65'536;

/// Cells of lists for each point, about: they are refined as room for points goes.
inline constexpr std::size_t cells_a_point = 4;

/// The buffers whose sizes are known beforehand, nearly.
inline NeededBuffers class_buffers(ClassDartBuffers& b, const ClassDartRequest& request)
{
    const std::size_t classes = request.distances.classes(), points = most_class_points(request);
    const auto axes = static_cast<std::size_t>(request.dimension);
    const CoveredGrids covered = covered_grids(request);
    NeededBuffers needed{{b.pairs, classes * classes},
                         {b.grids, classes},
                         {b.lists, classes},
                         {b.cells, std::max(classes, cells_a_point * points) * axes},
                         {b.starts, std::max(classes, cells_a_point * points)},
                         {b.kept, cells_a_point * points},
                         {b.slots, most_slots},
                         {b.candidates, most_slots * contract::class_darts::CANDIDATE_WORDS(axes)},
                         {b.heads, class_grids(request).cells},
                         {b.points, points * contract::class_darts::POINT_WORDS(axes)},
                         {b.covered_cells, classes},
                         {b.covered, covered.words},
                         {b.counters, contract::class_darts::COUNTERS}};
    if (request.region) std::ranges::copy(b.region.needed(*request.region), std::back_inserter(needed));
    return needed;
}

}
