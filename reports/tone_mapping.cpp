#include "reports/tone_mapping.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

double ToneMapping::position(double power) const
{
    if (!(power > 0)) return 0;
    const double t = std::log10(power / black_power) / std::log10(white_power / black_power);
    return std::clamp(t, 0.0, 1.0);
}

std::uint8_t ToneMapping::grey(double power) const
{
    return static_cast<std::uint8_t>(std::lround(255 * position(power)));
}

}
