#include "host/tile_construction/joint/unit_circle.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {

const std::vector<std::complex<double>>& unit_circle()
{
    static const auto circle = [] {
        std::vector<std::complex<double>> values;
        for (std::int32_t n = 0; n < tile_units; ++n) {
            const double angle = -2 * std::numbers::pi * n / tile_units;
            values.emplace_back(std::cos(angle), std::sin(angle));
        }
        return values;
    }();
    return circle;
}

}
