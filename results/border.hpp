// The border of sets that were made elsewhere, which may not be periodic: see analysis/borders/border_pairs.hpp.
#pragma once

#include <cstdint>
#include <string>

namespace poissonlab {

struct Series;

/// The finding on a series' border.
struct BorderResult
{
    std::uint64_t pairs_across = 0;   ///< of all sets, closer than the closest pair inside
    double chance = 1;                ///< of as many or more of periodic sets
    double relative_radius = 0;       ///< within the square (cube): of the closest pair inside, the mean over the sets
    double mean_nearest_distance = 0; ///< within the square (cube), of the largest possible distance

    bool operator==(const BorderResult&) const = default;

    /// True where the closest pairs meet across the border more often than chance allows.
    bool is_not_periodic() const;
};

/// A sentence or two for readers of a series whose sets are not periodic, without the program's own words for the way
/// out; empty for others.
std::string border_words(const Series& series);

/// The way to measure such sets, in the words of the command line, of configs and of Python.
std::string border_advice(int dimension);

}
