#include "analysis/tilings/lattice_share.hpp"

#include "base/errors/errors.hpp"

#include <string>

namespace poissonlab {

void need_tile_measures() {}

double lattice_share(const HalfSpectrum& periodogram, int tiles)
{
    if (tiles < 1) throw InputError("tiles = " + std::to_string(tiles) + ": must be at least 1");
    const int end = periodogram.size / 2, slices = periodogram.dimension == 3 ? end : 1;
    double all = 0, lattice = 0;
    for (int x = 0; x < end; ++x)
        for (int y = 1 - end; y < end; ++y)
            for (int z = 1 - slices; z < slices; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                const auto row = static_cast<std::size_t>(y + end);
                const std::size_t line = periodogram.dimension == 3 ? row : 0;
                const std::size_t last = periodogram.dimension == 3 ? static_cast<std::size_t>(z + end) : row;
                const std::size_t at =
                    (static_cast<std::size_t>(x) * periodogram.lines() + line) * periodogram.rows() + last;
                // Frequencies to the left have the power of their mirror images, which are stored.
                const double power = (x > 0 ? 2 : 1) * periodogram.power[at];
                all += power;
                if (x % tiles == 0 && y % tiles == 0 && z % tiles == 0) lattice += power;
            }
    return all > 0 ? lattice / all : 0;
}

}
