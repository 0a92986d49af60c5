#include "reports/images/tone_mapping.hpp"

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

GreyScale::GreyScale(const ToneMapping& tone_mapping)
{
    for (std::size_t i = 0; i < least_power_.size(); ++i) {
        // Bisection down to neighbouring numbers, so that the table has the rounding of grey() itself.
        double low = tone_mapping.black_power;
        double high = tone_mapping.white_power;
        for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
            (tone_mapping.grey(middle) > i ? high : low) = middle;
        least_power_[i] = high;
    }
}

std::uint8_t GreyScale::operator()(double power) const
{
    if (!(power > 0)) return 0;
    return static_cast<std::uint8_t>(std::ranges::upper_bound(least_power_, power) - least_power_.begin());
}

}
