// Means of spectra over sets of points with classes; a class can be without points in some of them.
#pragma once

#include "analysis/spectra/cross_spectrum.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The spectra of one set, and the classes that they are of, in rising order.
struct UsedSpectra
{
    std::vector<std::uint32_t> classes;
    CrossSpectra spectra;
};

struct ClassSpectra
{
    std::uint32_t sets = 1;
    std::vector<std::uint32_t> classes; ///< that have points in one of the sets or more
    CrossSpectra mean;
    CrossSpectra error; ///< standard errors of the means; of one set: nothing
};

/// Means over the sets in which a class, or both of a pair, have points. Values are NaN of a pair that has points in no
/// set at once, and errors where there is one set only. Takes one set or more, of equal numbers of bins.
ClassSpectra mean_spectra(const std::vector<UsedSpectra>& sets);

}
