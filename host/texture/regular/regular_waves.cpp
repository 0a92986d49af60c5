#include "host/texture/regular/regular_waves.hpp"

#include "host/texture/regular/wave_comb.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <utility>

namespace poissonlab {
namespace {

/// Powers of waves between whole numbers of periods, and of their harmonics.
class WavePower
{
public:
    WavePower(const LightMap& map, int harmonics) : map_(map), harmonics_(static_cast<std::size_t>(harmonics)) {}

    double of(double kx, double ky)
    {
        const std::vector<Harmonics>& rows = rows_of(kx);
        double power = 0;
        for (std::size_t k = 1; k <= harmonics_; ++k) {
            std::complex<double> sum = 0;
            for (std::size_t y = 0; y < rows.size(); ++y)
                sum += std::complex(rows[y][2 * k - 2], rows[y][2 * k - 1]) *
                       std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) * ky * static_cast<double>(y));
            power += std::norm(sum);
        }
        return power;
    }

private:
    /// Cosines and sines of all harmonics.
    using Harmonics = std::array<double, 2 * most_comb_harmonics>;

    /// The sums over each row, which all waves with the same number of periods a column share.
    const std::vector<Harmonics>& rows_of(double kx)
    {
        const auto [found, is_new] = rows_.try_emplace(kx);
        if (!is_new) return found->second;
        std::vector<Harmonics> turns(static_cast<std::size_t>(map_.width));
        for (std::size_t x = 0; x < turns.size(); ++x)
            for (std::size_t k = 1; k <= harmonics_; ++k) {
                const double angle = 2 * std::numbers::pi * static_cast<double>(k) * kx * static_cast<double>(x);
                turns[x][2 * k - 2] = std::cos(angle);
                turns[x][2 * k - 1] = -std::sin(angle);
            }
        std::vector<Harmonics>& rows = found->second;
        rows.resize(static_cast<std::size_t>(map_.height));
        tbb::parallel_for(0, map_.height, [&](int y) {
            Harmonics sums{};
            const double* const values = &map_.values[map_.index(0, y)];
            for (std::size_t x = 0; x < turns.size(); ++x)
                for (std::size_t i = 0; i < 2 * harmonics_; ++i) sums[i] += values[x] * turns[x][i];
            rows[static_cast<std::size_t>(y)] = sums;
        });
        return rows;
    }

    const LightMap& map_;
    std::size_t harmonics_;
    std::map<double, std::vector<Harmonics>> rows_;
};

/// Moves a wave to where it has most power with its harmonics, in steps down to a hundredth of a period over the
/// picture.
void refine(RegularWave& wave, const LightMap& map, int harmonics = wave_harmonics)
{
    WavePower power(map, harmonics);
    const RegularWave start = wave;
    std::pair<int, int> at{0, 0}; // in hundredths
    const auto moved = [&](const std::pair<int, int>& to) {
        RegularWave other = wave;
        other.x = start.x + to.first * 0.01 / map.width;
        other.y = start.y + to.second * 0.01 / map.height;
        return other;
    };
    double best = power.of(wave.x, wave.y);
    for (int step = 32; step > 0;) {
        std::pair<int, int> next = at;
        for (const auto& [dx, dy] :
             {std::pair(step, 0), std::pair(-step, 0), std::pair(0, step), std::pair(0, -step)}) {
            const RegularWave other = moved({at.first + dx, at.second + dy});
            if (const double its = power.of(other.x, other.y); its > best) {
                best = its;
                next = {at.first + dx, at.second + dy};
            }
        }
        if (next == at) step /= 2;
        at = next;
    }
    wave = moved(at);
}

RegularWave sum_of(const RegularWave& a, const RegularWave& b, const WaveSum& sum)
{
    return {sum.first * a.x + sum.second * b.x, sum.first * a.y + sum.second * b.y, 0, 0};
}

double product(const RegularWave& a, const RegularWave& b) { return a.x * b.x + a.y * b.y; }

/// The basis with a part of it as well, for n prime and j = 1, or j = 0 and i = 1. The first one stays if
/// it can, and the second one is as short as it can be beside it.
std::array<WaveSum, 2> with_part(const RegularWaves& found, const PartOfWaves& part)
{
    const RegularWave &a = found.strongest[0], &b = found.strongest[1];
    std::array<WaveSum, 2> basis = found.basis;
    basis[static_cast<std::size_t>(part.j)] = {(part.i * basis[0].first + part.j * basis[1].first) / part.n,
                                               (part.i * basis[0].second + part.j * basis[1].second) / part.n};
    const RegularWave first = sum_of(a, b, basis[0]), second = sum_of(a, b, basis[1]);
    // The last digits do not decide between two that are as short.
    const double times = std::round(product(first, second) / product(first, first) - 1e-6);
    basis[1].first -= times * basis[0].first;
    basis[1].second -= times * basis[0].second;
    return basis;
}

/// True if a basis with more between its waves was found.
bool refine_basis(RegularWaves& found, const WaveSpectrum& spectrum)
{
    const RegularWave &a = found.strongest[0], &b = found.strongest[1];
    const RegularWave first = sum_of(a, b, found.basis[0]), second = sum_of(a, b, found.basis[1]);
    std::array<WaveSum, 2> best{};
    double most = 0;
    for (const PartOfWaves& part :
         {PartOfWaves{2, 1, 0}, {2, 0, 1}, {2, 1, 1}, {3, 1, 0}, {3, 0, 1}, {3, 1, 1}, {3, 2, 1}}) {
        const PartsBetween power = spectrum.between(first, second, part, found.strongest);
        if (!stands_out_between(power)) continue;
        const double times = power.others.times + power.on_lines.times;
        if (times <= most) continue;
        const std::array<WaveSum, 2> basis = with_part(found, part);
        if (!spectrum.is_looked_at(sum_of(a, b, basis[0])) || !spectrum.is_looked_at(sum_of(a, b, basis[1]))) continue;
        most = times;
        best = basis;
    }
    if (most == 0) return false;
    found.basis = best;
    return true;
}

/// True if a wave is one of the first four harmonics of another one, to a period over the picture.
bool is_harmonic_of(const RegularWave& wave, const RegularWave& other, const LightMap& map)
{
    for (const double k : {1, 2, 3, 4})
        for (const double sign : {1, -1})
            if (std::hypot((wave.x - sign * k * other.x) * map.width, (wave.y - sign * k * other.y) * map.height) < 1)
                return true;
    return false;
}

/// Takes the wave whose harmonics stand out together if there is no other wave, or if the other wave is a harmonic of
/// it: all of its harmonics give the places of lines more exactly than four.
void take_comb(RegularWaves& found, const WaveSpectrum& spectrum, const LightMap& map)
{
    WaveComb comb = strongest_comb(spectrum);
    if (!stands_out_together(comb)) return;
    if (!found.strongest.empty() && !is_harmonic_of(found.strongest.front(), comb.wave, map)) return;
    refine(comb.wave, map, comb.harmonics);
    found.strongest = {comb.wave};
    found.is_comb = true;
}

/// Planks of all widths have their power on one line of the spectrum, where each place has many times the power around
/// it.
void drop_part_of_line(RegularWaves& found, const WaveSpectrum& spectrum)
{
    if (spectrum.times_along(found.strongest.front()) < least_regular_times) found.strongest.clear();
}

}

double RegularWave::period() const { return 1 / std::hypot(x, y); }

bool fits_tiles(const RegularWave& wave, int size)
{
    const double periods = std::hypot(std::remainder(wave.x * size, 1.0), std::remainder(wave.y * size, 1.0));
    return periods * wave.period() <= most_crest_offset;
}

RegularWave strongest_wave(const LightMap& light) { return WaveSpectrum(windowed(light)).strongest(); }

std::vector<RegularWave> RegularWaves::waves() const
{
    const auto is_strongest = [](const WaveSum& sum, double first, double second) {
        return sum.first == first && sum.second == second;
    };
    if (strongest.size() < 2 || (is_strongest(basis[0], 1, 0) && is_strongest(basis[1], 0, 1))) return strongest;
    return {sum_of(strongest[0], strongest[1], basis[0]), sum_of(strongest[0], strongest[1], basis[1])};
}

RegularWaves find_regular_waves(const LightMap& light)
{
    const LightMap map = windowed(light);
    const WaveSpectrum spectrum(map);
    RegularWaves found;
    const auto is_regular = [](const RegularWave& wave) { return stands_out({wave.share, wave.times}); };
    for (RegularWave wave = spectrum.strongest(); is_regular(wave);
         wave = spectrum.strongest(&found.strongest.front())) {
        refine(wave, map);
        found.strongest.push_back(wave);
        if (found.strongest.size() == 2) break;
    }
    if (found.strongest.size() == 1) drop_part_of_line(found, spectrum);
    if (found.strongest.size() < 2) take_comb(found, spectrum, map);
    if (found.strongest.size() == 2)
        while (refine_basis(found, spectrum)) {
        }
    return found;
}

std::vector<RegularWave> regular_waves(const LightMap& light) { return find_regular_waves(light).waves(); }

}
