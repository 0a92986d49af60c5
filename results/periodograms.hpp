// The number of periodograms that a series' spectrum is the mean of.
#pragma once

#include "results/series.hpp"

#include <algorithm>

namespace poissonlab {

/// The number of periodograms: one of each set, or of each set by each taper.
inline int periodograms_of(const Series& series)
{
    const std::size_t tapers = series.region ? std::max<std::size_t>(series.region->tapers, 1) : 1;
    return series.realizations * static_cast<int>(tapers);
}

}
