#include "reports/images/zone_plate_image.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

GreyImage draw_zone_plate(const SquareImage& image)
{
    GreyImage grey(image.size, image.size, 0);
    for (int row = 0; row < image.size; ++row)
        for (int column = 0; column < image.size; ++column)
            grey.at(column, image.size - 1 - row) =
                static_cast<std::uint8_t>(std::lround(255 * std::clamp(image.at(column, row), 0.0, 1.0)));
    return grey;
}

}
