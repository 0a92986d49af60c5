// Arithmetic of weights in the plain twins of kernels of endless textures: sums and products, in the order of
// kernels/common/fields/blended_pieces.clh.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace poissonlab {

/// Four steps of Newton's from a first guess by the bits of the number.
inline float newton_reciprocal(float v)
{
    float r = std::bit_cast<float>(0x7ef311c3u - std::bit_cast<std::uint32_t>(v));
    for (int i = 0; i < 4; ++i) r = r * (2.0f - v * r);
    return r;
}

inline float newton_reciprocal_root(float v)
{
    float r = std::bit_cast<float>(0x5f3759dfu - (std::bit_cast<std::uint32_t>(v) >> 1));
    for (int i = 0; i < 4; ++i) r = r * (1.5f - 0.5f * v * r * r);
    return r;
}

inline float whole_power(float v, int exponent)
{
    float product = v;
    for (int i = 1; i < exponent; ++i) product = product * v;
    return product;
}

/// Returns how far a square is blended into the next one, from a quarter to three quarters of the way, smoothly; of the
/// part of the way.
inline float smooth_step(float part)
{
    const float t = std::clamp((part - 0.25f) * 2.0f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// Makes the sum of weights 1.
inline void divide_weights(std::span<float> weights)
{
    float sum = 0;
    for (const float weight : weights) sum += weight;
    const float part = newton_reciprocal(sum);
    for (float& weight : weights) weight = weight * part;
}

/// Raises the contrast between weights, whose sum is 1.
inline void gain_weights(std::span<float> weights, int gain)
{
    if (gain == 1) return;
    for (float& w : weights)
        w = w < 0.5f ? 0.5f * whole_power(2.0f * w, gain) : 1.0f - 0.5f * whole_power(2.0f - 2.0f * w, gain);
    divide_weights(weights);
}

/// One over the deviation of a sum of independent values with these weights.
inline float restoring_factor(std::span<const float> weights)
{
    float squares = 0;
    for (const float weight : weights) squares += weight * weight;
    return newton_reciprocal_root(squares);
}

}
