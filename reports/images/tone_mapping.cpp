#include "reports/images/tone_mapping.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

// Positive numbers of the same exponent and the same first 8 digits are a step.
constexpr int step_bits = 44;

std::uint64_t step_of(double power) { return std::bit_cast<std::uint64_t>(power) >> step_bits; }

}

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
    for (std::size_t i = 0; i + 1 < least_power_.size(); ++i) {
        // Bisection down to neighbouring numbers, so that the table has the rounding of grey() itself.
        double low = tone_mapping.black_power;
        double high = tone_mapping.white_power;
        for (double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
            (tone_mapping.grey(middle) > i ? high : low) = middle;
        least_power_[i] = high;
    }
    least_power_.back() = std::numeric_limits<double>::infinity();
    for (std::uint64_t step = step_of(least_power_.front()); step <= step_of(*(least_power_.end() - 2)); ++step) {
        const auto lowest = std::bit_cast<double>(step << step_bits);
        first_grey_.push_back(
            static_cast<std::uint8_t>(std::ranges::upper_bound(least_power_, lowest) - least_power_.begin()));
    }
}

std::uint8_t GreyScale::operator()(double power) const
{
    if (!(power >= least_power_.front())) return 0;
    const std::uint64_t step = step_of(power) - step_of(least_power_.front());
    if (step >= first_grey_.size()) return 255;
    std::uint8_t grey = first_grey_[step];
    while (power >= least_power_[grey]) ++grey;
    return grey;
}

}
