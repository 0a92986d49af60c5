#include "analysis/measures/off_lattice_anisotropy.hpp"

#include "analysis/spectra/radial_statistics.hpp"

#include <cmath>
#include <vector>

namespace poissonlab {
namespace {

constexpr std::size_t least_samples = 100;

struct Ring
{
    std::size_t samples = 0;
    double sum = 0, squares = 0;
};

/// Rings one frequency wide, by their radius.
std::vector<Ring> rings_off_lattice(const Spectrum& spectrum, int tiles)
{
    const int half = spectrum.size / 2, slices = spectrum.dimension == 3 ? half - 1 : 0;
    std::vector<Ring> rings(static_cast<std::size_t>(half));
    const auto m = static_cast<std::size_t>(spectrum.size);
    for (int z = -slices; z <= slices; ++z)
        for (int y = -half + 1; y < half; ++y) {
            const std::size_t slice = spectrum.dimension == 3 ? static_cast<std::size_t>(z + half) : 0;
            const std::size_t row = (slice * m + static_cast<std::size_t>(y + half)) * m;
            for (int x = -half + 1; x < half; ++x) {
                if (x % tiles == 0 && y % tiles == 0 && z % tiles == 0) continue;
                const auto radius = static_cast<std::size_t>(std::lround(std::sqrt(x * x + y * y + z * z)));
                if (radius >= rings.size()) continue;
                const double power = spectrum.power[row + static_cast<std::size_t>(x + half)];
                ++rings[radius].samples;
                rings[radius].sum += power;
                rings[radius].squares += power * power;
            }
        }
    return rings;
}

}

std::optional<double> off_lattice_anisotropy_db(const Spectrum& spectrum, int tiles)
{
    if (spectrum.realizations < 2) return std::nullopt;
    double sum = 0;
    int count = 0;
    for (const Ring& ring : rings_off_lattice(spectrum, tiles)) {
        if (ring.samples < least_samples || !(ring.sum > 0)) continue;
        const auto n = static_cast<double>(ring.samples);
        const double mean = ring.sum / n, variance = (ring.squares - n * mean * mean) / (n - 1);
        if (!(variance > 0)) continue;
        sum += 10 * std::log10(variance / (mean * mean));
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / count - background_anisotropy_db(spectrum.realizations);
}

}
