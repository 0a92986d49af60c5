#include "host/texture/regular/wave_spectrum.hpp"

#include "analysis/spectra/fftw_plan.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <set>

namespace poissonlab {
namespace {

/// A wave is not given up for one of its harmonics that holds less than this part of its share, nor taken where less of
/// it is in harmonics that are looked at.
constexpr double least_harmonic = 0.5;

/// Waves are not parallel where the sine of their angle is larger.
constexpr double least_sine = 0.4;

std::vector<double> hann(int count)
{
    std::vector<double> weights;
    for (int i = 0; i < count; ++i) weights.push_back(0.5 - 0.5 * std::cos(2 * std::numbers::pi * (i + 0.5) / count));
    return weights;
}

bool is_parallel(const RegularWave& a, const RegularWave& b)
{
    return std::abs(a.x * b.y - a.y * b.x) < least_sine / (a.period() * b.period());
}

/// Adds up what `of_row` says of each, the same on any number of threads.
template <class OfRow>
double sum_of_rows(int rows, const OfRow& of_row)
{
    std::vector<double> sums(static_cast<std::size_t>(rows));
    tbb::parallel_for(0, rows, [&](int y) { sums[static_cast<std::size_t>(y)] = of_row(y); });
    return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}

LightMap windowed(LightMap light)
{
    const std::vector<double> across = hann(light.width), down = hann(light.height);
    const double weights =
        std::accumulate(across.begin(), across.end(), 0.0) * std::accumulate(down.begin(), down.end(), 0.0);
    const double mean =
        sum_of_rows(light.height,
                    [&](int y) {
                        return down[static_cast<std::size_t>(y)] *
                               std::inner_product(across.begin(), across.end(),
                                                  light.values.begin() + static_cast<std::ptrdiff_t>(light.index(0, y)),
                                                  0.0);
                    }) /
        weights;
    tbb::parallel_for(0, light.height, [&](int y) {
        for (int x = 0; x < light.width; ++x) {
            double& value = light.values[light.index(x, y)];
            value = across[static_cast<std::size_t>(x)] * down[static_cast<std::size_t>(y)] * (value - mean);
        }
    });
    return light;
}

bool stands_out(const PlacePower& power)
{
    return power.times >= least_regular_times && power.share >= least_regular_share;
}

bool stands_out_between(const PartsBetween& parts)
{
    constexpr double least_product = 0.18;
    const PlacePower& others = parts.others;
    return stands_out(parts.on_lines) ||
           (others.share >= least_regular_share / 2 && others.share * others.times >= least_product);
}

WaveSpectrum::WaveSpectrum(LightMap windowed) : width_(windowed.width), height_(windowed.height)
{
    const int columns = width_ / 2 + 1;
    std::vector<double>& values = windowed.values;
    total_ = std::inner_product(values.begin(), values.end(), values.begin(), 0.0) * width_ * height_;
    const auto transform = std::make_unique_for_overwrite<fftw_complex[]>(static_cast<std::size_t>(columns) *
                                                                          static_cast<std::size_t>(height_));
    const FftwPlan plan = make_fftw_plan(fftw_plan_dft_r2c_2d, height_, width_, values.data(), transform.get(),
                                         FFTW_ESTIMATE | FFTW_UNALIGNED);
    fftw_execute(plan.get());
    const auto share_at = [&](int x, int y) {
        const fftw_complex& value =
            transform[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
        return (value[0] * value[0] + value[1] * value[1]) / total_;
    };
    const auto wrapped = [](int i, int count) { return (i % count + count) % count; };
    const int right = width_ / 2, bottom = height_ / 2;
    shares_.resize(stored(right + margin, bottom + margin) + 1);
    auto share = shares_.begin();
    for (int y = -bottom - margin; y <= bottom + margin; ++y) {
        const int row = wrapped(y, height_), mirrored_row = wrapped(-y, height_);
        for (int x = -margin; x <= right + margin; ++x) {
            const bool is_held = x >= 0 && x < columns;
            const int column = is_held ? x : wrapped(x, width_);
            *share++ = column < columns ? share_at(column, row) : share_at(width_ - column, mirrored_row);
        }
    }
}

RegularWave WaveSpectrum::strongest(const RegularWave* other) const
{
    if (!(total_ > 0)) return {}; // one colour has no waves
    const Periods best = largest(other);
    for (int k = wave_harmonics; k > 1; --k) {
        if (stands_out(own_harmonics(best, k))) continue;
        const Periods multiple = largest_near({k * best.x, k * best.y});
        if (is_looked_at(multiple) && share_of(multiple) >= least_harmonic * share_of(best)) return wave(multiple);
    }
    return wave(best);
}

PartsBetween WaveSpectrum::between(const RegularWave& a, const RegularWave& b, const PartOfWaves& part,
                                   const std::vector<RegularWave>& lines) const
{
    std::set<std::pair<int, int>> found;
    for (int s = -2 * part.n; s <= 2 * part.n; ++s)
        for (int t = -2 * part.n; t <= 2 * part.n; ++t) {
            const Periods p = periods_of({(s * a.x + t * b.x) / part.n, (s * a.y + t * b.y) / part.n, 0, 0});
            if (part.holds(s, t) && is_below_highest(p.x, p.y) &&
                p.x * p.x + p.y * p.y >= least_periods * least_periods)
                found.insert({p.x, p.y});
        }
    std::vector<Periods> on, off;
    for (const auto& [x, y] : found) {
        const auto is_on = [&, x = x, y = y](const RegularWave& line) {
            const double east = line.x * width_, south = line.y * height_;
            return std::abs(x * south - y * east) <= 2 * std::hypot(east, south);
        };
        (std::ranges::any_of(lines, is_on) ? on : off).push_back({x, y});
    }
    return {power_beside(on, lines), power_beside(off, lines)};
}

/// Compared with the larger one of what is around the places and what is before and after them in directions of waves:
/// threads that differ from one another are lines of the spectrum, beside which there is nothing. Without the strongest
/// place, which may be strong by chance.
PlacePower WaveSpectrum::power_beside(std::vector<Periods> places, const std::vector<RegularWave>& directions) const
{
    if (places.empty()) return {};
    const double share = power_at(places).share;
    places.erase(std::ranges::max_element(places, {}, [&](const Periods& p) { return square_share(p.x, p.y, 1); }));
    const PlacePower others = power_at(places);
    double times = others.times;
    for (const RegularWave& direction : directions)
        if (const double along = share_along(places, direction); along > 0)
            times = std::min(times, others.share / along);
    return {share, times};
}

double WaveSpectrum::times_along(const RegularWave& wave) const
{
    const std::vector<Periods> places = looked_at_harmonics(periods_of(wave));
    const double share = power_at(places).share;
    return share > 0 ? share / share_along(places, wave) : 0;
}

bool WaveSpectrum::is_looked_at(const Periods& p) const
{
    return p.x * p.x + p.y * p.y >= least_periods * least_periods && p.x >= 0 && p.x <= width_ / least_wave_period &&
           std::abs(p.y) <= height_ / least_wave_period && (p.x > 0 || p.y > 0);
}

WaveSpectrum::Periods WaveSpectrum::periods_of(const RegularWave& wave) const
{
    const Periods p{static_cast<int>(std::lround(wave.x * width_)), static_cast<int>(std::lround(wave.y * height_))};
    return p.x < 0 || (p.x == 0 && p.y < 0) ? Periods{-p.x, -p.y} : p;
}

RegularWave WaveSpectrum::place(const Periods& p) const
{
    return {static_cast<double>(p.x) / width_, static_cast<double>(p.y) / height_, 0, 0};
}

WaveSpectrum::Periods WaveSpectrum::largest(const RegularWave* other) const
{
    const int most_x = width_ / least_wave_period, most_y = height_ / least_wave_period;
    std::vector<std::pair<double, Periods>> of_rows(static_cast<std::size_t>(2 * most_y + 1));
    tbb::parallel_for(-most_y, most_y + 1, [&](int y) {
        auto& [largest, best] = of_rows[static_cast<std::size_t>(y + most_y)];
        for (int x = 0; x <= most_x; ++x) {
            const Periods periods{x, y};
            if (!is_looked_at(periods) || (other && is_parallel(place(periods), *other))) continue;
            const double share = share_of(periods);
            if (share <= largest || power_at(looked_at_harmonics(periods)).share < least_harmonic * share) continue;
            largest = share;
            best = periods;
        }
    });
    return std::ranges::max_element(of_rows, {}, [](const auto& row) { return row.first; })->second;
}

/// Returns the best one of a place and those beside it: a multiple of a rounded place is up to half of that away for
/// each.
WaveSpectrum::Periods WaveSpectrum::largest_near(const Periods& p) const
{
    Periods best = p;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (const Periods other{p.x + dx, p.y + dy}; share_of(other) > share_of(best)) best = other;
    return best;
}

/// Adds up the harmonics of a wave that are none of its multiple's.
PlacePower WaveSpectrum::own_harmonics(const Periods& p, int multiple) const
{
    std::vector<Periods> places;
    for (int k = 1; k <= wave_harmonics && is_below_highest(k * p.x, k * p.y); ++k)
        if (k % multiple != 0) places.push_back({k * p.x, k * p.y});
    return power_at(places);
}

/// Adds up places with those beside them that the window spreads a wave between them over.
PlacePower WaveSpectrum::power_at(const std::vector<Periods>& places) const
{
    double share = 0, around = 0;
    for (const Periods& p : places) {
        share += 2 * square_share(p.x, p.y, 1);
        around += 2 * 9 * surrounding_share(p.x, p.y);
    }
    return {share, share > 0 ? share / around : 0};
}

/// The mean of as many places that are moved from these in a wave's direction.
double WaveSpectrum::share_along(const std::vector<Periods>& places, const RegularWave& wave) const
{
    constexpr int nearest = 3, farthest = 6;
    const double x = wave.x * width_, y = wave.y * height_, length = std::hypot(x, y);
    double sum = 0;
    for (const Periods& p : places)
        for (int away = nearest; away <= farthest; ++away)
            for (const int sign : {1, -1})
                sum += 2 * square_share(p.x + static_cast<int>(std::lround(sign * away * x / length)),
                                        p.y + static_cast<int>(std::lround(sign * away * y / length)), 1);
    return sum / (2 * (farthest - nearest + 1));
}

/// Adds up a wave and its harmonics below the highest frequency.
double WaveSpectrum::share_of(const Periods& p) const
{
    double sum = 0;
    for (int k = 1; k <= wave_harmonics && is_below_highest(k * p.x, k * p.y); ++k)
        sum += 2 * square_share(k * p.x, k * p.y, 1);
    return sum;
}

/// Returns the harmonics that are not finer than what is looked at: a fine wave has longer ones of which it is a
/// harmonic as well.
std::vector<WaveSpectrum::Periods> WaveSpectrum::looked_at_harmonics(const Periods& p) const
{
    std::vector<Periods> places;
    for (int k = 1; k <= wave_harmonics && is_looked_at(Periods{k * p.x, k * p.y}); ++k)
        places.push_back({k * p.x, k * p.y});
    return places;
}

/// Returns the wave with its share, and how many times what of it is looked at is what is around that; there may be
/// none.
RegularWave WaveSpectrum::wave(const Periods& p) const
{
    RegularWave wave = place(p);
    if (p.x == 0 && p.y == 0) return wave;
    wave.share = share_of(p);
    wave.times = power_at(looked_at_harmonics(p)).times;
    return wave;
}

double WaveSpectrum::wrapped_share(int x, int y) const
{
    const auto nearest = [](int i, int count) {
        return i - count * static_cast<int>(std::lround(static_cast<double>(i) / count));
    };
    x = nearest(x, width_);
    y = nearest(y, height_);
    return shares_[x < 0 ? stored(-x, -y) : stored(x, y)];
}

double WaveSpectrum::square_share(int x, int y, int reach) const
{
    double sum = 0;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) sum += share(x + dx, y + dy);
    return sum;
}

/// The mean of a ring around the places that a wave is spread over.
double WaveSpectrum::surrounding_share(int x, int y) const
{
    constexpr int inner = 2, outer = 6;
    constexpr double count = (2 * outer + 1) * (2 * outer + 1) - (2 * inner + 1) * (2 * inner + 1);
    return (square_share(x, y, outer) - square_share(x, y, inner)) / count;
}

}
