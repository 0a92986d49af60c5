#include "host/texture/regular/wave_comb.hpp"

#include "tiles/texture/square_means.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace poissonlab {
namespace {

/// The logarithm of a ratio of powers has this standard deviation (see the header).
constexpr double log_deviation = 1.01;

constexpr double least_comb_deviations = 6, least_comb_share = 0.005;
constexpr int least_comb_harmonics = 3;

/// Only combs that have one of the places that stand out most as a harmonic are examined. The first number is that of
/// these places; the second is the least ratio of a place's power to the power around it.
constexpr std::size_t most_places = 64;
constexpr double least_place_times = 3;

/// Powers are compared with those that are this number of places before and after them.
constexpr double least_steps_away = 4, most_steps_away = 6;

/// Rounding has less than this share of the power, but may be periodic in pictures without noise.
constexpr double least_power = 1e-5;

struct SpectrumPlace
{
    double x = 0;
    double y = 0;
    double times = 0;
};

class CombSearch
{
public:
    explicit CombSearch(const WaveSpectrum& spectrum)
        : spectrum_(spectrum), right_(spectrum.width() / 2), bottom_(spectrum.height() / 2),
          columns_(right_ + 2 * margin + 1), powers_(spectrum.shares().size()), arounds_(spectrum.shares().size())
    {
        const SquareMeans means(spectrum.shares(), columns_);
        const int rows = static_cast<int>(spectrum.shares().size()) / columns_;
        const auto square = [&](int column, int row, int reach) {
            const int side = 2 * reach + 1;
            return means.mean(column - reach, row - reach, column + reach + 1, row + reach + 1) * side * side;
        };
        for (int row = 1; row + 1 < rows; ++row)
            for (int column = 1; column + 1 < columns_; ++column)
                powers_[index(column, row)] = std::max(0.0, square(column, row, 1));
        constexpr int inner = 2, outer = 6;
        constexpr double count = (2 * outer + 1) * (2 * outer + 1) - (2 * inner + 1) * (2 * inner + 1);
        for (int row = outer; row + outer < rows; ++row)
            for (int column = outer; column + outer < columns_; ++column)
                arounds_[index(column, row)] =
                    std::max(0.0, square(column, row, outer) - square(column, row, inner)) * 9 / count;
    }

    std::vector<SpectrumPlace> places() const
    {
        std::vector<SpectrumPlace> found;
        for (int y = 1 - bottom_; y < bottom_; ++y)
            for (int x = 0; x < right_; ++x) {
                if (x * x + y * y < least_periods * least_periods || (x == 0 && y < 0)) continue;
                const double power = power_at(x, y), times = power / std::max(least_power, around(x, y));
                if (times >= least_place_times && is_highest(x, y, power)) found.push_back(centroid(x, y, times));
            }
        const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min(most_places, found.size()));
        std::partial_sort(found.begin(), end, found.end(),
                          [](const SpectrumPlace& a, const SpectrumPlace& b) { return a.times > b.times; });
        found.erase(end, found.end());
        return found;
    }

    /// Returns the comb of a wave with x periods over the width and y over the height, with the number of harmonics
    /// that stand out most. Waves that are not looked at have none.
    WaveComb comb_of(double x, double y) const
    {
        WaveComb best, all;
        all.wave.x = x / spectrum_.width();
        all.wave.y = y / spectrum_.height();
        if (!spectrum_.is_looked_at(all.wave)) return {};
        const double length = std::hypot(x, y),
                     away = std::clamp(length / 2, least_steps_away, most_steps_away) / length;
        double logarithms = 0, powers = 0, arounds = 0;
        for (int k = 1; k <= most_comb_harmonics && is_within(k * x, k * y); ++k) {
            const auto [power, beside] = harmonic(x, y, k, away);
            logarithms += std::log((power + least_power) / (beside + least_power));
            powers += power;
            arounds += beside;
            all.wave.share += 2 * std::max(0.0, power - beside);
            all.deviations = logarithms / (log_deviation * std::sqrt(k));
            all.harmonics = k;
            if (all.deviations <= best.deviations) continue;
            best = all;
            best.wave.times = powers / std::max(least_power, arounds);
        }
        return best;
    }

    /// Moves a comb to where it stands out most, in steps as small as its last harmonic can resolve.
    WaveComb refined(WaveComb comb) const
    {
        for (double step = 0.25; step > 0.25 / most_comb_harmonics;) {
            WaveComb next = comb;
            const double x = comb.wave.x * spectrum_.width(), y = comb.wave.y * spectrum_.height();
            for (const auto& [dx, dy] : {std::array{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
                const WaveComb other = comb_of(x + dx, y + dy);
                if (other.deviations > next.deviations) next = other;
            }
            if (next.deviations == comb.deviations) step /= 2;
            comb = next;
        }
        return comb;
    }

private:
    /// Squares of this reach are summed beyond the highest frequency as well.
    static constexpr int margin = WaveSpectrum::margin;

    struct HarmonicPower
    {
        double power = 0;
        double beside = 0;
    };

    /// A wave to the south may lean to the west by a few periods.
    bool is_within(double x, double y) const { return x > -margin / 2.0 && x < right_ && std::abs(y) < bottom_; }

    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    std::size_t place_of(int x, int y) const { return index(x + margin, y + bottom_ + margin); }

    /// Returns the power of a place and of the eight places beside it.
    double power_at(int x, int y) const { return powers_[place_of(x, y)]; }

    /// Returns the mean power of nine places in a ring around a place.
    double around(int x, int y) const { return arounds_[place_of(x, y)]; }

    /// Compares a harmonic with what is around it and with places so many waves before and after it.
    HarmonicPower harmonic(double x, double y, int k, double away) const
    {
        const auto at = [&](double times, const auto& of) {
            return of(static_cast<int>(std::lround(times * x)), static_cast<int>(std::lround(times * y)));
        };
        const auto power = [this](int i, int j) { return power_at(i, j); };
        return {at(k, power), std::max(at(k, [this](int i, int j) { return around(i, j); }),
                                       (at(k - away, power) + at(k + away, power)) / 2)};
    }

    bool is_highest(int x, int y, double power) const
    {
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (power_at(x + dx, y + dy) > power) return false;
        return true;
    }

    /// A wave between whole numbers of periods is spread over the places around it.
    SpectrumPlace centroid(int x, int y, double times) const
    {
        double sum = 0, east = 0, south = 0;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const double share = spectrum_.share(x + dx, y + dy);
                sum += share;
                east += dx * share;
                south += dy * share;
            }
        return {x + east / sum, y + south / sum, times};
    }

    const WaveSpectrum& spectrum_;
    int right_, bottom_, columns_;
    std::vector<double> powers_, arounds_; ///< of all places, as most are asked for many times
};

}

WaveComb strongest_comb(const WaveSpectrum& spectrum)
{
    const CombSearch search(spectrum);
    WaveComb best;
    for (const SpectrumPlace& place : search.places())
        for (int k = 1; k <= most_comb_harmonics; ++k) {
            const WaveComb comb = search.comb_of(place.x / k, place.y / k);
            if (comb.deviations > best.deviations) best = comb;
        }
    return best.harmonics > 0 ? search.refined(best) : best;
}

bool stands_out_together(const WaveComb& comb)
{
    return comb.harmonics >= least_comb_harmonics && comb.deviations >= least_comb_deviations &&
           comb.wave.share >= least_comb_share;
}

}
