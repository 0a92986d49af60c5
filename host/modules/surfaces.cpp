// Points on surfaces.
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_surfaces(Laboratory& laboratory) { laboratory.kinds.push_back(surface_point_kind()); }

}
