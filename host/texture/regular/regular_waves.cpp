#include "host/texture/regular/regular_waves.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <optional>

namespace poissonlab {
namespace {

constexpr int harmonics = 4;
constexpr int least_periods = 8; ///< over the picture

/// Waves hold at least so much of the variance: without noise, the smallest would be many times what is around it.
constexpr double least_share = 0.02;

/// A wave is told from those of twice to four times its period, of which it is a harmonic: the longest of several
/// whose shares are nearly as large is not taken.
constexpr double nearly = 0.9;

/// Waves are not parallel where the sine of their angle is larger.
constexpr double least_sine = 0.4;

/// The window of von Hann.
std::vector<double> hann(int count)
{
    std::vector<double> weights;
    for (int i = 0; i < count; ++i) weights.push_back(0.5 - 0.5 * std::cos(2 * std::numbers::pi * (i + 0.5) / count));
    return weights;
}

/// Differences from the mean, smaller towards the rim, where a picture does not go on.
LightMap windowed(const LightMap& light)
{
    LightMap map = light;
    const std::vector<double> across = hann(map.width), down = hann(map.height);
    const auto weight = [&](int x, int y) {
        return across[static_cast<std::size_t>(x)] * down[static_cast<std::size_t>(y)];
    };
    double sum = 0, weights = 0;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) {
            sum += weight(x, y) * light.at(x, y);
            weights += weight(x, y);
        }
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            map.values[map.index(x, y)] = weight(x, y) * (light.at(x, y) - sum / weights);
    return map;
}

/// A power spectrum by whole numbers of periods over the width and the height.
class WaveSpectrum
{
public:
    explicit WaveSpectrum(const LightMap& map) : width_(map.width), height_(map.height), columns_(map.width / 2 + 1)
    {
        std::vector<double> values = map.values;
        std::vector<std::complex<double>> transform(static_cast<std::size_t>(columns_) *
                                                    static_cast<std::size_t>(height_));
        const FftwPlan plan = make_fftw_plan(fftw_plan_dft_r2c_2d, height_, width_, values.data(),
                                             fftw(transform.data()), FFTW_ESTIMATE | FFTW_UNALIGNED);
        fftw_execute(plan.get());
        for (const std::complex<double>& value : transform) powers_.push_back(std::norm(value));
        total_ = std::inner_product(map.values.begin(), map.values.end(), map.values.begin(), 0.0) * width_ * height_;
    }

    /// The strongest wave, of those that are not parallel to another one if there is one.
    RegularWave strongest(const std::optional<RegularWave>& other = {}) const
    {
        if (!(total_ > 0)) return {}; // one colour has no waves
        const Periods best = largest(other);
        for (int k = harmonics; k > 1; --k)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const Periods multiple{k * best.x + dx, k * best.y + dy};
                    if (is_looked_at(multiple) && share_of(multiple) >= nearly * share_of(best)) return wave(multiple);
                }
        return wave(best);
    }

private:
    /// Whole numbers of them over the width and the height.
    struct Periods
    {
        int x = 0;
        int y = 0;
    };

    bool is_looked_at(const Periods& p) const
    {
        return p.x * p.x + p.y * p.y >= least_periods * least_periods && p.x >= 0 &&
               p.x <= width_ / least_wave_period && std::abs(p.y) <= height_ / least_wave_period &&
               (p.x > 0 || p.y > 0);
    }

    Periods largest(const std::optional<RegularWave>& other) const
    {
        Periods best;
        double largest = 0;
        const int most_y = height_ / least_wave_period;
        for (int y = -most_y; y <= most_y; ++y)
            for (int x = 0; x <= width_ / least_wave_period; ++x) {
                const Periods periods{x, y};
                if (!is_looked_at(periods) || (other && is_parallel(place(periods), *other))) continue;
                const double share = share_of(periods);
                if (share <= largest) continue;
                largest = share;
                best = periods;
            }
        return best;
    }

    RegularWave place(const Periods& p) const
    {
        return {static_cast<double>(p.x) / width_, static_cast<double>(p.y) / height_, 0, 0};
    }

    /// With its share and how many times that is what is around it; nothing where there is none.
    RegularWave wave(const Periods& p) const
    {
        RegularWave wave = place(p);
        if (p.x == 0 && p.y == 0) return wave;
        wave.share = share_of(p);
        wave.times = wave.share / harmonic_sum(p, [&](int x, int y) { return 9 * surrounding_share(x, y); });
        return wave;
    }

    double share_of(const Periods& p) const
    {
        return harmonic_sum(p, [&](int x, int y) { return near_share(x, y); });
    }

    static bool is_parallel(const RegularWave& a, const RegularWave& b)
    {
        return std::abs(a.x * b.y - a.y * b.x) < least_sine / (a.period() * b.period());
    }

    double share(int x, int y) const
    {
        x = (x % width_ + width_) % width_;
        if (x >= columns_) {
            x = width_ - x;
            y = -y;
        }
        y = (y % height_ + height_) % height_;
        return powers_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)] /
               total_;
    }

    /// Adds up the places that the window spreads a wave between them over.
    double near_share(int x, int y) const { return square_share(x, y, 1); }

    /// The mean of a ring around those.
    double surrounding_share(int x, int y) const
    {
        constexpr int inner = 2, outer = 6;
        constexpr double count = (2 * outer + 1) * (2 * outer + 1) - (2 * inner + 1) * (2 * inner + 1);
        return (square_share(x, y, outer) - square_share(x, y, inner)) / count;
    }

    double square_share(int x, int y, int reach) const
    {
        double sum = 0;
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) sum += share(x + dx, y + dy);
        return sum;
    }

    /// Over a wave and its harmonics below the highest frequency, of both signs.
    template <class Share>
    double harmonic_sum(const Periods& p, const Share& its) const
    {
        double sum = 0;
        for (int k = 1; k <= harmonics && 2 * k * p.x < width_ && 2 * k * std::abs(p.y) < height_; ++k)
            sum += 2 * its(k * p.x, k * p.y);
        return sum;
    }

    int width_, height_, columns_;
    std::vector<double> powers_;
    double total_ = 0;
};

/// The power of a wave between whole numbers of periods, and of its harmonics.
double power_of(const LightMap& map, double kx, double ky)
{
    double power = 0;
    for (int k = 1; k <= harmonics; ++k) {
        std::vector<std::complex<double>> row(static_cast<std::size_t>(map.width));
        for (int x = 0; x < map.width; ++x)
            row[static_cast<std::size_t>(x)] = std::polar(1.0, -2 * std::numbers::pi * k * kx * x);
        std::complex<double> sum = 0;
        for (int y = 0; y < map.height; ++y) {
            std::complex<double> its = 0;
            for (int x = 0; x < map.width; ++x) its += map.at(x, y) * row[static_cast<std::size_t>(x)];
            sum += its * std::polar(1.0, -2 * std::numbers::pi * k * ky * y);
        }
        power += std::norm(sum);
    }
    return power;
}

/// Moves a wave to where it has most power, in steps down to a hundredth of a period over the picture.
void refine(RegularWave& wave, const LightMap& map)
{
    double best = power_of(map, wave.x, wave.y);
    for (double step = 0.32; step > 0.005;) {
        RegularWave next = wave;
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
            const double x = wave.x + dx * step / map.width, y = wave.y + dy * step / map.height;
            if (const double power = power_of(map, x, y); power > best) {
                best = power;
                next.x = x;
                next.y = y;
            }
        }
        if (next.x == wave.x && next.y == wave.y) step /= 2;
        wave = next;
    }
}

}

double RegularWave::period() const { return 1 / std::hypot(x, y); }

bool fits_tiles(const RegularWave& wave, int size)
{
    const double periods = std::hypot(std::remainder(wave.x * size, 1.0), std::remainder(wave.y * size, 1.0));
    return periods * wave.period() <= most_crest_offset;
}

RegularWave strongest_wave(const LightMap& light) { return WaveSpectrum(windowed(light)).strongest(); }

std::vector<RegularWave> regular_waves(const LightMap& light)
{
    const LightMap map = windowed(light);
    const WaveSpectrum spectrum(map);
    std::vector<RegularWave> waves;
    const auto is_regular = [](const RegularWave& wave) {
        return wave.times >= least_regular_times && wave.share >= least_share;
    };
    for (RegularWave wave = spectrum.strongest(); is_regular(wave); wave = spectrum.strongest(waves.front())) {
        refine(wave, map);
        waves.push_back(wave);
        if (waves.size() == 2) break;
    }
    return waves;
}

}
