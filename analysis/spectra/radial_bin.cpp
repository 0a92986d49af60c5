#include "analysis/spectra/radial_bin.hpp"

#include <cmath>
#include <limits>

namespace poissonlab {

RadialBins::RadialBins(int size, double width) : width_(width), ends_{0}
{
    for (int k = 1; 0.5 + k * width <= 0.5 * size - 0.5; ++k) {
        const double end = 0.5 + k * width; // its square is exact for whole numbers and halves
        ends_.push_back(static_cast<std::int64_t>(std::floor(end * end)));
    }
    ends_.push_back(std::numeric_limits<std::int64_t>::max());
}

}
