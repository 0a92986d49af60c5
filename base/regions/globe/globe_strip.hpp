// Longitudes and latitudes as a strip of a plane, where edges are straight as RFC 7946 has them: parts that lie across
// the antimeridian go on beyond 180 degrees, and rings around a pole have a seam to it.
#pragma once

#include "base/regions/obstacles.hpp"

#include <string>

namespace poissonlab {

/// Moves parts by whole turns of longitude, of which one has `turn` units, so that all of them lie side by side: those
/// that a file has cut at the antimeridian share an edge then. Throws InputError that begins with `name` for edges of
/// more than half a turn, but for those along a pole and those of a whole turn along a parallel.
Obstacles laid_in_strip(Obstacles shapes, double turn, const std::string& name);

}
