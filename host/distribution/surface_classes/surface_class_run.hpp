// The kind of points of several classes on a mesh.
#pragma once

#include "host/kinds/kind.hpp"

namespace poissonlab {

/// Returns kind = "surface-classes".
Kind surface_class_kind();

}
