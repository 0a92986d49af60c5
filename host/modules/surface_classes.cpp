// Points of several classes on meshes.
#include "host/distribution/surface_classes/surface_class_run.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_surface_classes(Laboratory& laboratory) { laboratory.kinds.push_back(surface_class_kind()); }

}
