// Bytes of sRGB as light, and back: averages are taken of light, and light is written as bytes that screens show.
//
// IEC 61966-2-1. The light of bytes is a whole number of 65535ths, so that no last bit of a power decides anything.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace poissonlab {

/// The light of a value of sRGB, and the value of a light, both from 0 to 1.
inline double light_of_srgb(double value)
{
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}
inline double srgb_of_light(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

/// The light of each byte: 0 to 65535.
const std::array<float, 256>& light_of_bytes();

/// The byte whose light is nearest by sRGB's curve; the inverse of light_of_bytes().
std::uint8_t byte_of_light(float light);

}
