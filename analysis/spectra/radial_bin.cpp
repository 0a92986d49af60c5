#include "analysis/spectra/radial_bin.hpp"

#include <limits>

namespace poissonlab {

RadialBins::RadialBins(int size, double width, const PeriodicBox& box) : width_(width), squared_steps_(), ends_{0}
{
    for (std::size_t k = 0; k < box.sides.size(); ++k) squared_steps_[k] = 1 / (box.sides[k] * box.sides[k]);
    const double reach = (0.5 * size - 0.5) / box.longest();
    for (int k = 1; 0.5 + k * width <= reach; ++k) {
        const double end = 0.5 + k * width; // its square is exact for whole numbers and halves
        ends_.push_back(end * end);
    }
    ends_.push_back(std::numeric_limits<double>::infinity());
}

}
