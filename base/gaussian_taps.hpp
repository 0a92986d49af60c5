// Weights of a Gaussian at whole distances, by additions and multiplications alone: the same on every machine.
#pragma once

#include <vector>

namespace poissonlab {

/// exp(-k^2 / (2 sigma^2)) for k from 0 to six sigma, each over the sum of all on both sides.
inline std::vector<double> gaussian_taps(double sigma)
{
    const double exponent = 1 / (2 * sigma * sigma);
    double first = 1; // exp(-exponent), by its series
    for (int n = 20; n > 0; --n) first = 1 - exponent / n * first;
    std::vector<double> taps{1};
    double sum = 1, ratio = first;
    while (static_cast<double>(taps.size()) <= 6 * sigma) {
        taps.push_back(taps.back() * ratio);
        sum += 2 * taps.back();
        ratio *= first * first;
    }
    for (double& tap : taps) tap /= sum;
    return taps;
}

}
