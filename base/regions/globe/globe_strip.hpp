// Longitudes and latitudes as a strip of a plane, where edges are straight as RFC 7946 has them: lines that cross the
// antimeridian go on beyond 180 degrees, and rings around a pole run along it.
#pragma once

#include "base/regions/obstacles.hpp"

namespace poissonlab {

/// Moves corners by whole turns of longitude, of which one has `turn` units, so that no edge goes farther than half a
/// turn, and parts so that all of them lie side by side: those that a file has cut at the antimeridian share an edge
/// then. Rings that go around a pole get an edge along it, on their side of the equator. Edges along a pole, and along
/// a whole parallel, stay.
Obstacles laid_in_strip(Obstacles shapes, double turn);

}
