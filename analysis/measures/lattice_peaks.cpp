#include "analysis/measures/lattice_peaks.hpp"

#include "analysis/spectra/frequency_power.hpp"
#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace poissonlab {

namespace {

using Frequency = std::array<int, 3>;

/// The power at which the rounding of periodograms ends.
double least_power(std::size_t points) { return 1e-22 * static_cast<double>(points); }

/// Powers around frequencies; power(f) gives that of a frequency.
template <class Power>
class Rings
{
public:
    Rings(int dimension, int size, std::size_t points, int tiles, const Power& power)
        : power_(power), dimension_(dimension), half_(size / 2), width_(std::min(3, tiles - 1)),
          least_power_(least_power(points))
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

/// Calls visit(f, power around f) for each multiple of `tiles` whose ring lies in the spectrum.
template <class Power, class Visit>
void for_each_peak(const Rings<Power>& rings, int dimension, int size, int tiles, const Visit& visit)
{
    std::vector<int> multiples;
    for (int f = -(size / 2 / tiles) * tiles; f < size / 2; f += tiles) {
        if (rings.fits(f)) multiples.push_back(f);
    }
    for (const int z : dimension == 3 ? multiples : std::vector{0})
        for (const int y : multiples)
            for (const int x : multiples)
                if (x != 0 || y != 0 || z != 0) visit(Frequency{x, y, z}, rings.around({x, y, z}));
}

void check_tiles(int tiles)
{
    if (tiles < 2) throw InputError("tiles = " + std::to_string(tiles) + ": must be at least 2");
}

template <class Power>
LatticePeaks peaks_of(int dimension, int size, std::size_t points, int tiles, const Power& power)
{
    check_tiles(tiles);
    const Rings<Power> rings(dimension, size, points, tiles, power);
    LatticePeaks result;
    result.tiles = tiles;
    for_each_peak(rings, dimension, size, tiles, [&](const Frequency& f, double around) {
        const double ratio = rings.ratio(f, around);
        if (result.peaks == 0 || ratio > result.max_ratio) {
            result.max_ratio = ratio;
            result.frequency = f;
        }
        result.mean_ratio += ratio;
        result.empty_rings += rings.is_empty(around);
        ++result.peaks;
    });
    if (result.peaks > 0) result.mean_ratio /= static_cast<double>(result.peaks);
    return result;
}

/// The power at frequencies of a spectrum or a half of one.
auto powers_of_frequencies(const auto& spectrum)
{
    return [&spectrum](const Frequency& f) { return frequency_power(spectrum, f); };
}

/// Peaks are near up to a little beyond the principal frequency, in parts of it.
constexpr double near_end = 1.05;

template <class Power>
std::vector<double> near_powers(int dimension, int size, std::size_t points, int tiles, const Power& power)
{
    check_tiles(tiles);
    const Rings rings(dimension, size, points, tiles, power);
    const double limit = near_end * principal_frequency(points, dimension);
    const auto reach = std::min(static_cast<int>(limit), size / 2 - 1);
    const int slices = dimension == 3 ? reach : 0;
    std::vector<double> powers{0};
    for (int z = -slices; z <= slices; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const Frequency f{x, y, z};
                if (x * x + y * y + z * z > limit * limit || (x == 0 && y == 0 && z == 0)) continue;
                powers[0] += power(f);
                if (x % tiles != 0 || y % tiles != 0 || z % tiles != 0) continue;
                if (!rings.fits(x) || !rings.fits(y) || (slices > 0 && !rings.fits(z))) continue;
                powers.insert(powers.end(), {power(f), rings.around(f)});
            }
    return powers;
}

}

LatticePeaks lattice_peaks(const Spectrum& spectrum, int tiles)
{
    return peaks_of(spectrum.dimension, spectrum.size, spectrum.points, tiles, powers_of_frequencies(spectrum));
}

std::optional<NearLatticePeaks> near_lattice_peaks(const Spectrum& spectrum, int tiles)
{
    return near_lattice_peaks(
        near_powers(spectrum.dimension, spectrum.size, spectrum.points, tiles, powers_of_frequencies(spectrum)),
        spectrum.points);
}

std::vector<double> near_lattice_powers(const HalfSpectrum& periodogram, std::size_t points, int tiles)
{
    return near_powers(periodogram.dimension, periodogram.size, points, tiles, powers_of_frequencies(periodogram));
}

std::optional<NearLatticePeaks> near_lattice_peaks(const std::vector<double>& powers, std::size_t points)
{
    const std::size_t peaks = powers.size() / 2;
    if (peaks == 0 || !(powers[0] > 0)) return std::nullopt;
    double ratios = 0, excess = 0;
    for (std::size_t i = 0; i < peaks; ++i) {
        const double power = powers[2 * i + 1], around = powers[2 * i + 2];
        ratios += power / std::max(around, least_power(points));
        excess += power - around;
    }
    return NearLatticePeaks{ratios / static_cast<double>(peaks), excess / powers[0]};
}

std::vector<double> lattice_shell_powers(const HalfSpectrum& periodogram, std::size_t points, int tiles)
{
    check_tiles(tiles);
    const auto power = powers_of_frequencies(periodogram);
    const Rings rings(periodogram.dimension, periodogram.size, points, tiles, power);
    std::vector<double> shells;
    for_each_peak(rings, periodogram.dimension, periodogram.size, tiles, [&](const Frequency& f, double around) {
        const double length = std::hypot(f[0], f[1], f[2]);
        const std::size_t begin = 3 * static_cast<std::size_t>(2 * length / tiles);
        if (begin >= shells.size()) shells.resize(begin + 3);
        shells[begin] += 1;
        shells[begin + 1] += power(f);
        shells[begin + 2] += around;
    });
    return shells;
}

double mean_ratio_of_shells(const std::vector<double>& shells, std::size_t points)
{
    double peaks = 0, ratios = 0;
    for (std::size_t i = 0; i < shells.size(); i += 3) {
        if (!(shells[i] > 0)) continue; // a shell between multiples
        peaks += shells[i];
        ratios += shells[i] * shells[i + 1] / std::max(shells[i + 2], shells[i] * least_power(points));
    }
    return peaks > 0 ? ratios / peaks : 0;
}

}
