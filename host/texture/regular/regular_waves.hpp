// This finds what is regular in a picture: waves that go on over all of it, as courses of bricks and threads do.
//
// A wave and its harmonics, the first four, hold a share of the picture's variance. In a picture without order each
// part of the spectrum is about as high as what is around it; a wave is regular where its share is many times as high.
// Bricks, of the exemplars here, have 28 times as much seen at an angle, made straight 139, fabric 690; a wall of rough
// stones has 15, all others have at most 3.5.
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

/// From so many times on a wave is regular.
inline constexpr double least_regular_times = 20;

/// The wave with the largest share that has at least eight periods over the picture.
RegularWave strongest_wave(const LightMap& light);

/// Regular waves of a picture: none, one, or two that are not parallel, the one with the larger share first. Places of
/// waves are exact to about a hundredth of a period over the whole picture.
std::vector<RegularWave> regular_waves(const LightMap& light);

}
