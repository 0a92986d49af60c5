// This finds what is regular in a picture: waves that go on over all of it, as courses of bricks and threads do.
//
// A wave and its harmonics, the first four, hold a share of the picture's variance. In a picture without order each
// part of the spectrum is about as high as what is around it; a wave is regular where its share is many times as high.
//
// If no wave stands out, or if one that does is a harmonic of another one, more harmonics are examined: wave_comb.hpp.
// A wave that no other one crosses must also stand out from the power before and after it in its direction.
//
// A wave explains its harmonics, and two waves all sums of them. Where something between these stands out as well, the
// picture repeats after two or three of their periods only: the halves and thirds of sums are tried, as long as there
// is one that stands out. Threads of a plain weave, for one, are seen best along both axes, but turns of what lies
// above recur at the half of the sum of these waves.
#pragma once

#include "host/texture/comparison/light_map.hpp"

#include <array>
#include <vector>

namespace poissonlab {

/// Waves of shorter periods are not looked for, in pixels.
inline constexpr int least_wave_period = 6;

struct RegularWave
{
    double x = 0; ///< periods a pixel, to the east and to the south
    double y = 0;
    double share = 0; ///< of the picture's variance, of the wave and its harmonics
    double times = 0; ///< how many times what is around them in the spectrum

    double period() const; ///< in pixels, across the wave's crests
};

/// Pixels that crests may be away from where they should be.
inline constexpr double most_crest_offset = 1;

/// True if a wave has nearly whole numbers of periods over T pixels along both axes: its crests are at most a pixel
/// away from there after T pixels.
bool fits_tiles(const RegularWave& wave, int size);

/// A wave is regular if it is at least so many times what is around it in the spectrum.
inline constexpr double least_regular_times = 20;

/// Waves hold at least so much of the variance: without noise, the smallest would be many times what is around it.
inline constexpr double least_regular_share = 0.02;

/// The wave with the largest share that has at least eight periods over the picture; of several whose periods are
/// multiples of one another the longest that has harmonics of its own.
RegularWave strongest_wave(const LightMap& light);

/// A number of each of two waves.
struct WaveSum
{
    double first = 0;
    double second = 0;
};

/// Regular waves of a picture: none, one, or the strongest two that are not parallel. Places of waves are exact to
/// about a hundredth of a period over the whole picture.
struct RegularWaves
{
    std::vector<RegularWave> strongest; ///< the one with the larger share first
    /// All regular waves are sums of whole numbers of these two: the strongest, unless what they belong to repeats
    /// after more than a period of both only, as threads do that lie over each other by turns.
    std::array<WaveSum, 2> basis{{{1, 0}, {0, 1}}};
    bool is_comb = false; ///< one wave, whose harmonics stand out together

    /// One or both of the basis, that of the strongest first, unless what repeats takes more than one of its periods.
    std::vector<RegularWave> waves() const;
};
RegularWaves find_regular_waves(const LightMap& light);

/// Waves of the basis alone.
std::vector<RegularWave> regular_waves(const LightMap& light);

}
