// Which methods of the gallery are better than somebody's sets.
#pragma once

#include "reports/gallery/gallery.hpp"
#include "results/measures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Returns the value of a measure in the gallery; none where the gallery lacks it.
std::optional<MeasuredValue> value_in_gallery(const GalleryMethod& method, const Measure& measure);

/// "Relative radius: 2 of 3 methods are better, the best is A (0.925).": those whose values differ by more than two
/// standard errors, and in the digits that are shown. The title is in words of the dimension. Empty for measures
/// without an order, and where the series or the gallery has no value.
std::string better_in_gallery(const Measure& measure, const Series& series, int dimension,
                              const std::vector<const GalleryMethod*>& gallery);

}
