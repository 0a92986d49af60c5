// The power spectrum of a picture, in which waves and their harmonics stand out.
#pragma once

#include "host/texture/regular/regular_waves.hpp"

#include <cmath>
#include <vector>

namespace poissonlab {

/// Waves have at least this number of periods over the picture.
inline constexpr int least_periods = 8;

/// A wave and the next harmonics count, four in all.
inline constexpr int wave_harmonics = 4;

/// Differences from the mean, smaller towards the rim, where a picture does not go on: by the window of von Hann.
LightMap windowed(LightMap light);

/// The power that places of a spectrum hold.
struct PlacePower
{
    double share = 0; ///< of the picture's variance, of places and their mirror images
    double times = 0; ///< how many times what is around them
};

/// Sums (s a + t b) / n of two waves that are multiples of (i a + j b) / n, but for whole numbers of both.
struct PartOfWaves
{
    int n, i, j;

    bool holds(int s, int t) const
    {
        for (int k = 1; k < n; ++k)
            if ((s - k * i) % n == 0 && (t - k * j) % n == 0) return true;
        return false;
    }
};

/// The power of places on lines of the spectrum, and of the others.
struct PartsBetween
{
    PlacePower on_lines, others;
};

class WaveSpectrum
{
public:
    /// Shares of a half of the spectrum are stored with so many places around it, which searches look at most.
    static constexpr int margin = 16;

    explicit WaveSpectrum(LightMap windowed);

    /// The strongest wave that has at least eight periods over the picture, of those that are not parallel to another
    /// one if there is one. Of a wave and those of twice to four times its period, of which it is a harmonic, a longer
    /// one is taken only where it has a harmonic of its own that stands out.
    RegularWave strongest(const RegularWave* other = nullptr) const;

    /// The power of the waves of a part of two others, up to twice each, but for those below eight periods. Lines go
    /// through no wave and each of `lines`.
    PartsBetween between(const RegularWave& a, const RegularWave& b, const PartOfWaves& part,
                         const std::vector<RegularWave>& lines) const;

    /// Returns the ratio of the power of a wave and its harmonics to the power before and after them in its direction.
    double times_along(const RegularWave& wave) const;

    int width() const { return width_; }
    int height() const { return height_; }

    /// Returns the share of the variance at a place, for any whole numbers of periods.
    double share(int x, int y) const
    {
        const bool is_stored = x >= -margin && x <= width_ / 2 + margin && std::abs(y) <= height_ / 2 + margin;
        return is_stored ? shares_[stored(x, y)] : wrapped_share(x, y);
    }

    /// Returns the shares from `margin` places before a half of the spectrum to `margin` after it: x from 0 to half of
    /// the width, y from less than 0 to more by half of the height, row by row.
    const std::vector<double>& shares() const { return shares_; }

    /// True if waves of this period are looked for.
    bool is_looked_at(const RegularWave& wave) const { return is_looked_at(periods_of(wave)); }

private:
    /// Whole numbers of them over the width and the height.
    struct Periods
    {
        int x = 0;
        int y = 0;
    };

    bool is_looked_at(const Periods& p) const;
    Periods periods_of(const RegularWave& wave) const;
    RegularWave place(const Periods& p) const;
    Periods largest(const RegularWave* other) const;
    Periods largest_near(const Periods& p) const;
    PlacePower own_harmonics(const Periods& p, int multiple) const;
    PlacePower power_beside(std::vector<Periods> places, const std::vector<RegularWave>& directions) const;
    double share_along(const std::vector<Periods>& places, const RegularWave& wave) const;
    PlacePower power_at(const std::vector<Periods>& places) const;
    double share_of(const Periods& p) const;
    std::vector<Periods> looked_at_harmonics(const Periods& p) const;
    RegularWave wave(const Periods& p) const;

    double square_share(int x, int y, int reach) const;
    double surrounding_share(int x, int y) const;
    bool is_below_highest(int x, int y) const { return 2 * std::abs(x) < width_ && 2 * std::abs(y) < height_; }

    double wrapped_share(int x, int y) const;
    std::size_t stored(int x, int y) const
    {
        return static_cast<std::size_t>(y + height_ / 2 + margin) *
                   static_cast<std::size_t>(width_ / 2 + 2 * margin + 1) +
               static_cast<std::size_t>(x + margin);
    }

    int width_, height_;
    double total_ = 0;
    std::vector<double> shares_; ///< see shares()
};

/// True of what regular waves have: a share of the variance that is many times what is around it.
bool stands_out(const PlacePower& power);

/// True if what is between two regular waves is regular as well. There are few such places, so that less is needed: by
/// chance they have once what is around them, and the less they hold the more they have to stand out. Of 40 plain
/// weaves whose threads wander and differ as those of synthetic_exemplar() do, turns are found in 39.
bool stands_out_between(const PartsBetween& parts);

}
