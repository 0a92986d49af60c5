// Numbers of a ring as people write them: "1 + @60", "2 phi@36", "(2 + sqrt3) @30".
//
// @A is the unit vector at A degrees. i, phi, sqrt2 and sqrt3 are the numbers that these words say, in rings that have
// them. Factors stand side by side or with * between them.
#pragma once

#include "tiles/prototiles/polygon_tiling.hpp"
#include "tiles/prototiles/root_ring.hpp"

#include <string_view>

namespace poissonlab {

/// Throws InputError that says what of the text is wrong.
RingPlace ring_expression(const RootRing& ring, std::string_view text);

/// A number that may have the shifts p and q as well: "phi + @144 p". Throws InputError that says what of the text is
/// wrong.
ShiftedPlace shifted_expression(const RootRing& ring, std::string_view text);

}
