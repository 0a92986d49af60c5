// Fields of plants by layered depth images of tiles.
#include "host/distribution/geometry_tiles/geometry_tile_run.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_geometry_tiles(Laboratory& laboratory) { laboratory.kinds.push_back(geometry_tile_kind()); }

}
