#include "reports/images/density_image.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double white_density = 2;

}

GreyImage draw_density(const SquareImage& image, int magnification)
{
    const int size = image.size * magnification;
    GreyImage grey(size, size, 0);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double share = image.at(column / magnification, row / magnification) / white_density;
            grey.at(column, size - 1 - row) = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
        }
    return grey;
}

}
