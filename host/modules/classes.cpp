// Points of several classes, on the torus, in regions, and of tiles.
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_classes(Laboratory& laboratory) { laboratory.kinds.push_back(class_kind()); }

}
