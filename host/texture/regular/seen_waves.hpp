// This finds what is regular in a picture of a plane that was seen at an angle, and how the plane was seen.
//
// Two numbers of a projective map, the line at which parallels meet, decide whether courses are alike everywhere: those
// are taken with which a wave and its harmonics hold the largest share of the picture's variance. They are looked for
// in a small copy of the whole picture, and in copies of smaller and smaller parts of its middle, which show finer
// waves. What is found there, if it stands out more, is followed to the rim of the picture.
#pragma once

#include "host/texture/regular/regular_waves.hpp"
#include "host/texture/regular/wave_tracking.hpp"

#include <vector>

namespace poissonlab {

struct SeenWaves
{
    Slope slope;
    std::vector<RegularWave> waves; ///< in the middle, once the slope is undone; periods a pixel of the picture
    double most_times = 0;          ///< how many times what is around it the strongest wave of any part has
    bool is_lost = false;           ///< waves of the middle do not go on over all of the picture
};

/// Finds the waves of an exemplar, and the slope of its plane. The result does not depend on the number of threads.
SeenWaves seen_waves(const PngPixels& exemplar);

/// The shortest period that is found, in pixels of the exemplar.
double least_seen_period(const PngPixels& exemplar);

}
