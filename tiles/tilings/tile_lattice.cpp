#include "tiles/tilings/tile_lattice.hpp"

#include "base/errors/errors.hpp"

#include <string>

namespace poissonlab {

Period checked_period(const Period& period)
{
    for (const std::int64_t p : {period.x, period.y, period.z}) {
        if (p < 0 || p >= std::int64_t{1} << 62)
            throw InputError("period = " + std::to_string(p) +
                             ": must be an integer from 1 to 2^62 - 1, or 0 for none");
    }
    return period;
}

}
