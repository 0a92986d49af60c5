#include "host/sampling/cells/region_buffers.hpp"

#include <algorithm>
#include <iterator>

namespace poissonlab {

NeededBuffers RegionBuffers::needed(const FixedRegion& region)
{
    return {{cells, region.cells().size()}, {edges, region.edges().size() * 4}, {filled, region.filled().size()}};
}

void RegionBuffers::write(const FixedRegion& region)
{
    cells.write(region.cells());
    edges.write({region.edges().data()->data(), region.edges().size() * 4});
    filled.write(region.filled());
}

contract::regions::RegionGrid region_grid(const FixedRegion& region)
{
    contract::regions::RegionGrid grid{
        .squared_margins = {}, .margins = {}, .bits = static_cast<unsigned>(region.bits())};
    std::ranges::copy(region.squared_margins(), std::begin(grid.squared_margins));
    std::ranges::copy(region.margins(), std::begin(grid.margins));
    return grid;
}

}
