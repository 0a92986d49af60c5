// kind = "geometry-tiles".
#pragma once

#include "host/kinds/kind.hpp"

namespace poissonlab {

Kind geometry_tile_kind();

}
