#include "analysis/lattice_peaks.hpp"

#include "errors/errors.hpp"

#include <algorithm>
#include <string>

namespace poissonlab {

namespace {

using Frequency = std::array<int, 3>;

class Rings
{
public:
    Rings(const Spectrum& spectrum, int tiles)
        : spectrum_(spectrum), width_(std::min(3, tiles - 1)),
          least_power_(1e-22 * static_cast<double>(spectrum.points))
    {}

    bool fits(int along) const
    {
        const int half = spectrum_.size / 2;
        return along - width_ >= -half && along + width_ < half;
    }

    double ratio(const Frequency& f) const
    {
        const int slices = spectrum_.dimension == 3 ? width_ : 0;
        double sum = 0;
        int samples = 0;
        for (int z = -slices; z <= slices; ++z) {
            for (int y = -width_; y <= width_; ++y) {
                for (int x = -width_; x <= width_; ++x) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    sum += power({f[0] + x, f[1] + y, f[2] + z});
                    ++samples;
                }
            }
        }
        return power(f) / std::max(sum / samples, least_power_);
    }

private:
    double power(const Frequency& f) const
    {
        const auto m = static_cast<std::size_t>(spectrum_.size);
        const auto index = [&](int along) { return static_cast<std::size_t>(along + spectrum_.size / 2); };
        const std::size_t slice = spectrum_.dimension == 3 ? index(f[2]) : 0;
        return spectrum_.power[(slice * m + index(f[1])) * m + index(f[0])];
    }

    const Spectrum& spectrum_;
    int width_;
    double least_power_;
};

}

LatticePeaks lattice_peaks(const Spectrum& spectrum, int tiles)
{
    if (tiles < 2) throw InputError("tiles = " + std::to_string(tiles) + ": must be at least 2");
    const Rings rings(spectrum, tiles);
    std::vector<int> multiples;
    for (int f = -(spectrum.size / 2 / tiles) * tiles; f < spectrum.size / 2; f += tiles) {
        if (rings.fits(f)) multiples.push_back(f);
    }

    LatticePeaks result;
    result.tiles = tiles;
    for (const int z : spectrum.dimension == 3 ? multiples : std::vector{0}) {
        for (const int y : multiples) {
            for (const int x : multiples) {
                if (x == 0 && y == 0 && z == 0) continue;
                const double ratio = rings.ratio({x, y, z});
                if (result.peaks == 0 || ratio > result.max_ratio) {
                    result.max_ratio = ratio;
                    result.frequency = {x, y, z};
                }
                result.mean_ratio += ratio;
                ++result.peaks;
            }
        }
    }
    if (result.peaks > 0) result.mean_ratio /= static_cast<double>(result.peaks);
    return result;
}

}
