#include "analysis/measures/lattice_peaks.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace poissonlab {

namespace {

using Frequency = std::array<int, 3>;

/// Powers around frequencies; power(f) gives that of a frequency.
template <class Power>
class Rings
{
public:
    Rings(int dimension, int size, std::size_t points, int tiles, const Power& power)
        : power_(power), dimension_(dimension), half_(size / 2), width_(std::min(3, tiles - 1)),
          least_power_(1e-22 * static_cast<double>(points))
    {}

    bool is_empty(double around) const { return around < 1e10 * least_power_; }

    bool fits(int along) const { return along - width_ >= -half_ && along + width_ < half_; }

    /// The power at a frequency over that `around`.
    double ratio(const Frequency& f, double around) const { return power_(f) / std::max(around, least_power_); }

    /// The mean power of the ring.
    double around(const Frequency& f) const
    {
        const int slices = dimension_ == 3 ? width_ : 0;
        double sum = 0;
        int samples = 0;
        for (int z = -slices; z <= slices; ++z) {
            for (int y = -width_; y <= width_; ++y) {
                for (int x = -width_; x <= width_; ++x) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    sum += power_({f[0] + x, f[1] + y, f[2] + z});
                    ++samples;
                }
            }
        }
        return sum / samples;
    }

private:
    const Power& power_;
    int dimension_, half_, width_;
    double least_power_;
};

template <class Power>
LatticePeaks peaks_of(int dimension, int size, std::size_t points, int tiles, const Power& power)
{
    if (tiles < 2) throw InputError("tiles = " + std::to_string(tiles) + ": must be at least 2");
    const Rings<Power> rings(dimension, size, points, tiles, power);
    std::vector<int> multiples;
    for (int f = -(size / 2 / tiles) * tiles; f < size / 2; f += tiles) {
        if (rings.fits(f)) multiples.push_back(f);
    }

    LatticePeaks result;
    result.tiles = tiles;
    for (const int z : dimension == 3 ? multiples : std::vector{0}) {
        for (const int y : multiples) {
            for (const int x : multiples) {
                if (x == 0 && y == 0 && z == 0) continue;
                const double around = rings.around({x, y, z});
                const double ratio = rings.ratio({x, y, z}, around);
                if (result.peaks == 0 || ratio > result.max_ratio) {
                    result.max_ratio = ratio;
                    result.frequency = {x, y, z};
                }
                result.mean_ratio += ratio;
                result.empty_rings += rings.is_empty(around);
                ++result.peaks;
            }
        }
    }
    if (result.peaks > 0) result.mean_ratio /= static_cast<double>(result.peaks);
    return result;
}

/// The power at a frequency.
auto power_of(const Spectrum& spectrum)
{
    return [&spectrum](const Frequency& f) {
        const auto m = static_cast<std::size_t>(spectrum.size);
        const auto index = [&](int along) { return static_cast<std::size_t>(along + spectrum.size / 2); };
        const std::size_t slice = spectrum.dimension == 3 ? index(f[2]) : 0;
        return spectrum.power[(slice * m + index(f[1])) * m + index(f[0])];
    };
}

/// Peaks are near up to a little beyond the principal frequency, in parts of it.
constexpr double near_end = 1.05;

}

LatticePeaks lattice_peaks(const Spectrum& spectrum, int tiles)
{
    return peaks_of(spectrum.dimension, spectrum.size, spectrum.points, tiles, power_of(spectrum));
}

std::optional<NearLatticePeaks> near_lattice_peaks(const Spectrum& spectrum, int tiles)
{
    if (tiles < 2) throw InputError("tiles = " + std::to_string(tiles) + ": must be at least 2");
    const auto power = power_of(spectrum);
    const Rings rings(spectrum.dimension, spectrum.size, spectrum.points, tiles, power);
    const double limit = near_end * principal_frequency(spectrum.points, spectrum.dimension);
    const auto reach = std::min(static_cast<int>(limit), spectrum.size / 2 - 1);
    const int slices = spectrum.dimension == 3 ? reach : 0;
    double ratios = 0, excess = 0, all = 0;
    int peaks = 0;
    for (int z = -slices; z <= slices; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const Frequency f{x, y, z};
                if (x * x + y * y + z * z > limit * limit || (x == 0 && y == 0 && z == 0)) continue;
                all += power(f);
                if (x % tiles != 0 || y % tiles != 0 || z % tiles != 0) continue;
                if (!rings.fits(x) || !rings.fits(y) || (slices > 0 && !rings.fits(z))) continue;
                const double around = rings.around(f);
                ratios += rings.ratio(f, around);
                excess += power(f) - around;
                ++peaks;
            }
    if (peaks == 0 || !(all > 0)) return std::nullopt;
    return NearLatticePeaks{ratios / peaks, excess / all};
}

LatticePeaks lattice_peaks(const HalfSpectrum& periodogram, std::size_t points, int tiles)
{
    const auto index = [&](int along) { return static_cast<std::size_t>(along + periodogram.size / 2); };
    return peaks_of(periodogram.dimension, periodogram.size, points, tiles, [&](const Frequency& f) {
        const int sign = f[0] < 0 ? -1 : 1; // of f and -f, the one that is stored
        const auto u = static_cast<std::size_t>(sign * f[0]);
        const std::size_t y = index(sign * f[1]);
        if (periodogram.dimension == 2) return periodogram.power[u * periodogram.rows() + y];
        return periodogram.power[(u * periodogram.lines() + y) * periodogram.rows() + index(sign * f[2])];
    });
}

}
