// The one tone mapping of a report: power to grey, logarithmic, the same for every spectrum image.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Grey is linear in log10(power) from black_power (0) to white_power (255), and clamped beyond.
///
/// The grey value is the stored one, which viewers treat as sRGB, so equal ratios of power look like about
/// equal steps. With power 1 for white noise, the range covers the dark centre of the best sets and their
/// ring.
struct ToneMapping
{
    double black_power = 0.01;
    double white_power = 10;

    /// Zero, negative and not-a-number powers are black.
    std::uint8_t grey(double power) const;

    /// The place of a power on the scale from black (0) to white (1).
    double position(double power) const;
};

/// The grey values of a tone mapping, from a table: the same as grey(), without logarithms, for images.
class GreyScale
{
public:
    explicit GreyScale(const ToneMapping& tone_mapping);

    /// Zero, negative and not-a-number powers are black.
    std::uint8_t operator()(double power) const;

private:
    /// Buckets of powers, 64 an octave: each has one grey or two.
    static std::uint64_t bucket_of(double power) { return std::bit_cast<std::uint64_t>(power) >> 46; }

    std::array<double, 255> least_power_; ///< [i]: the smallest power with grey i + 1
    std::uint64_t first_bucket_ = 0;
    std::vector<std::uint8_t> least_grey_; ///< of each bucket
};

/// Fixed, so that images of different reports compare as well.
inline constexpr ToneMapping report_tone_mapping{};

}
