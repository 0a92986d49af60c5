// Objects at the points of a tile set's tilings: the look-ups of the header that engines use.
#pragma once

#include "tiles/poisson/tile_lookup.hpp"

#include "runtime/object_distribution.h"
