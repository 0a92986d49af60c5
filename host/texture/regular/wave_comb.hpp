// Waves whose harmonics stand out together: thin lines, such as the joints of planks, have their power in many
// harmonics, none of which need stand out alone.
//
// A harmonic is compared with what is around it in the spectrum, and with what is before and after it in the wave's
// direction: planks that differ, and their grain, have their power on one line of the spectrum. By chance the power of
// a place is exponential there. Those of three neighbours, by the window of von Hann, have the correlations (2/3)^2 and
// (1/6)^2, so that their sum is about a gamma variate of the shape m = 9 / (3 + 4 (2/3)^2 + 2 (1/6)^2) = 1.86. The
// logarithm of its ratio to the mean of two such sums has the variance psi'(m) + psi'(2 m) = 1.02 and a mean below 0,
// and large values are rarer than those of a normal variate. The sum of n logarithms, divided by its standard
// deviation, is therefore at most as often large. Where power is not on a line, sums of nine places vary less.
#pragma once

#include "host/texture/regular/wave_spectrum.hpp"

namespace poissonlab {

/// Harmonics beyond these are not looked at.
inline constexpr int most_comb_harmonics = 32;

struct WaveComb
{
    /// The first harmonic, between whole numbers of periods over the picture. Its share is that of all harmonics beyond
    /// what is around them.
    RegularWave wave;
    int harmonics = 0;     ///< that stand out together most
    double deviations = 0; ///< standard deviations by which their logarithms exceed chance
};

/// The comb with most deviations. Of a wave and its harmonics this is the wave, because a multiple of it leaves out
/// harmonics, and a part adds places between them. It is the same on any number of threads.
WaveComb strongest_comb(const WaveSpectrum& spectrum);

/// True if at least three harmonics stand out together by six deviations. About 10^7 combs of a picture are compared,
/// at all angles from which it may have been seen, and chance has one of 10^9. The share is at least 0.5 %: without
/// noise, blocks of compressed pictures would stand out.
bool stands_out_together(const WaveComb& comb);

}
