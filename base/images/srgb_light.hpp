// Bytes of sRGB as light, and back: averages are taken of light, and light is written as bytes that screens show.
//
// IEC 61966-2-1. Light is a whole number of 65535ths, so that no last bit of a power decides anything.
#pragma once

#include <array>
#include <cstdint>

namespace poissonlab {

/// The light of each byte: 0 to 65535.
const std::array<float, 256>& light_of_bytes();

/// The byte whose light is nearest by sRGB's curve; the inverse of light_of_bytes().
std::uint8_t byte_of_light(float light);

}
