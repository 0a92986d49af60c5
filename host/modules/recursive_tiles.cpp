// Windows of endless recursive tilings, and pictures that are painted at their points.
#include "host/distribution/recursive_tiles/recursive_tile_run.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_recursive_tiles(Laboratory& laboratory) { laboratory.kinds.push_back(recursive_tile_kind()); }

}
