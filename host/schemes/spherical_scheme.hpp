// kind = "spherical".
#pragma once

#include "host/kinds/kind.hpp"

namespace poissonlab {

Kind spherical_kind();

}
