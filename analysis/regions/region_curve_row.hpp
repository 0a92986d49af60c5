// The curves of points in a region at one distance.
#pragma once

#include <array>
#include <cstddef>

namespace poissonlab {

/// The functions that have envelopes, in the order of tables.
enum class RegionFunction : std::size_t
{
    pair_correlation, ///< g, smooth
    k,                ///< by the translation correction
    nearest,          ///< G
    empty_space,      ///< F
    j
};
inline constexpr std::size_t region_functions = 5;

/// All curves at one distance.
struct RegionCurveRow
{
    double distance = 0; ///< in the region's own units
    double k_isotropic = 0;
    std::array<double, region_functions> value{};
    std::array<double, region_functions> low{}; ///< of the envelope; not numbers without one
    std::array<double, region_functions> high{};

    double of(RegionFunction f) const { return value[static_cast<std::size_t>(f)]; }
};

}
