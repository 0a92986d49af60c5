#include "host/sampling/cells/region_buffers.hpp"

#include <algorithm>
#include <iterator>

namespace poissonlab {

static_assert(contract::spaces::LATTICE_SHIFT == FixedSpace::lattice_shift);

NeededBuffers RegionBuffers::needed(const FixedRegion& region)
{
    return {{cells, region.all_cells().size()}, {edges, region.edges().size() * 4}, {filled, region.filled().size()}};
}

void RegionBuffers::write(const FixedRegion& region)
{
    cells.write(region.all_cells());
    edges.write({region.edges().data()->data(), region.edges().size() * 4});
    filled.write(region.filled());
}

contract::regions::RegionGrid region_grid(const FixedRegion& region)
{
    contract::regions::RegionGrid grid{.squared_margins = {},
                                       .margins = {},
                                       .bits = static_cast<unsigned>(region.bits()),
                                       .fine_bits = static_cast<unsigned>(region.fine_bits()),
                                       .unused = 0};
    std::ranges::copy(region.squared_margins(), std::begin(grid.squared_margins));
    std::ranges::copy(region.margins(), std::begin(grid.margins));
    return grid;
}

NeededBuffers SpaceBuffers::needed(const FixedSpace& space)
{
    return {{values, std::max<std::size_t>(1, space.values().size())},
            {filled, std::max<std::size_t>(1, space.filled().size())}};
}

void SpaceBuffers::write(const FixedSpace& space)
{
    if (space.values().empty()) return;
    values.write(space.values());
    filled.write(space.filled());
}

contract::spaces::SpaceGrid space_grid(const FixedSpace& space)
{
    using enum contract::spaces::Shape;
    constexpr std::array shapes{SPACE_BOX, SPACE_BALL, SPACE_SOLID};
    contract::spaces::SpaceGrid grid{.squared_radius = space.squared_radius(),
                                     .low = {},
                                     .high = {},
                                     .cells = {},
                                     .shape = shapes[static_cast<std::size_t>(space.shape())]};
    std::ranges::copy(space.limits().low, std::begin(grid.low));
    std::ranges::copy(space.limits().high, std::begin(grid.high));
    std::ranges::copy(space.cells(), std::begin(grid.cells));
    return grid;
}

}
