// Points of several classes, on the torus, in regions, and of tiles.
#include "host/distribution/classes/class_set.hpp"
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_classes(Laboratory& laboratory)
{
    for (Kind (*const kind)() : {class_kind, class_set_kind}) laboratory.kinds.push_back(kind());
}

}
