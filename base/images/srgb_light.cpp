#include "base/images/srgb_light.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// The light of a value between two bytes, in 65535ths.
double light_of(double byte) { return 65535 * light_of_srgb(byte / 255); }

}

const std::array<float, 256>& light_of_bytes()
{
    static const std::array<float, 256> all = [] {
        std::array<float, 256> light{};
        for (std::size_t byte = 0; byte < light.size(); ++byte)
            light[byte] = static_cast<float>(std::round(light_of(static_cast<double>(byte))));
        return light;
    }();
    return all;
}

std::uint8_t byte_of_light(float light)
{
    // The least light of each byte but the first, half-way between two by the curve.
    static const std::array<float, 255> least = [] {
        std::array<float, 255> all{};
        for (std::size_t byte = 0; byte < all.size(); ++byte)
            all[byte] = static_cast<float>(std::round(light_of(static_cast<double>(byte) + 0.5) * 16) / 16);
        return all;
    }();
    return static_cast<std::uint8_t>(std::ranges::upper_bound(least, light) - least.begin());
}

}
