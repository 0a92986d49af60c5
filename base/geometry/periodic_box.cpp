#include "base/geometry/periodic_box.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

double PeriodicBox::shortest() const { return *std::ranges::min_element(sides); }

double PeriodicBox::longest() const { return *std::ranges::max_element(sides); }

double root_of_volume(std::span<const double> sides)
{
    double logarithms = 0; // products of three large numbers may be too large
    for (const double side : sides) logarithms += std::log(side);
    return std::exp(logarithms / static_cast<double>(sides.size()));
}

PeriodicBox periodic_box(std::span<const double> sides)
{
    PeriodicBox box;
    if (std::ranges::adjacent_find(sides, std::not_equal_to{}) == sides.end()) return box;
    const double unit = root_of_volume(sides);
    for (std::size_t k = 0; k < sides.size(); ++k) box.sides[k] = sides[k] / unit;
    return box;
}

}
