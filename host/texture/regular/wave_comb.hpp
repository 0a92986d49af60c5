// Finds waves whose harmonics stand out together. Thin lines, such as the joints of planks, have their power in many
// harmonics, none of which needs to stand out alone.
//
// A harmonic is compared with the power around it in the spectrum, and with the power before and after it in the wave's
// direction, because planks that differ, and their grain, have their power on one line of the spectrum. By chance the
// power of a place there is distributed exponentially. With the window of von Hann, the powers of three neighbours have
// the correlations (2/3)^2 and (1/6)^2, so that their sum is approximately a gamma variate of the shape m = 9 / (3 + 4
// (2/3)^2 + 2 (1/6)^2) = 1.86. The logarithm of its ratio to the mean of two such sums has the variance psi'(m) +
// psi'(2 m) = 1.02 and a mean below 0, and large values are rarer than those of a normal variate. The sum of n
// logarithms, divided by its standard deviation, is therefore large no more often than a normal variate. If the power
// is not on a line, sums of nine places vary less.
#pragma once

#include "host/texture/regular/wave_spectrum.hpp"

namespace poissonlab {

/// Higher harmonics are not examined.
inline constexpr int most_comb_harmonics = 32;

struct WaveComb
{
    /// The first harmonic, between whole numbers of periods over the picture. Its share is the power by which
    /// all harmonics exceed the power around them.
    RegularWave wave;
    int harmonics = 0;     ///< the number of harmonics that stand out most together
    double deviations = 0; ///< standard deviations by which their logarithms exceed chance
};

/// Returns the comb with most deviations. Its wave is the fundamental one, because a multiple of it leaves out
/// harmonics, and a fraction of it adds places between them. It is the same on any number of threads.
WaveComb strongest_comb(const WaveSpectrum& spectrum);

/// True if at least three harmonics stand out together by six deviations. About 10^7 combs of a picture are compared,
/// at all angles from which it may have been seen, and by chance one in 10^9 has six deviations. The share must be at
/// least 0.5 %, because otherwise the blocks of compressed pictures without noise would stand out.
bool stands_out_together(const WaveComb& comb);

}
