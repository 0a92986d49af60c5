// Repetition that shows wherever a lattice may lie: the largest correlation of a picture with itself, moved.
//
// By chance alone the correlations of far places of a random field are as large as Bartlett's formula has it: their
// variance is the sum of all squared correlations over the number of places (Bartlett, On the Theoretical
// Specification and Sampling Properties of Autocorrelated Time-Series, 1946). The largest one of m such is about
// sqrt(2 ln m) standard deviations.
#pragma once

#include "host/texture/comparison/light_map.hpp"

namespace poissonlab {

/// Correlations of a map with itself at all distances up to a quarter of its sides to the east and the south, and to
/// the west and the south: over the pairs of places that the map has.
class SelfCorrelation
{
public:
    explicit SelfCorrelation(const LightMap& map);

    /// The correlation at a distance of (dx, dy), dy from 0 to height / 4, dx from -width / 4 to width / 4.
    double at(int dx, int dy) const;

    int most_dx() const { return width_ / 4; }
    int most_dy() const { return height_ / 4; }

private:
    int width_, height_;
    std::size_t line_;           ///< numbers a row
    std::vector<double> values_; ///< of maps with a border of zeros, over which opposite sides meet; row by row
};

struct CorrelationPeak
{
    double correlation = 0;
    int dx = 0; ///< where it is
    int dy = 0;
};

/// The largest correlation at distances of `least` places and more.
CorrelationPeak correlation_peak(const SelfCorrelation& correlations, int least);

/// The largest correlation that chance makes in a map of width x height places of a random field whose correlations
/// below `least` are those of `sample`.
double chance_of_peak(const SelfCorrelation& sample, int least, int width, int height);

}
