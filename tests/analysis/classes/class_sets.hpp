// Point sets and places for tests of classes.
#pragma once

#include "analysis/classes/class_pairs.hpp"
#include "base/regions/region_text.hpp"

#include <cstddef>
#include <memory>
#include <random>

namespace poissonlab {

inline PointSet random_class_set(std::size_t count, std::mt19937_64& random)
{
    std::uniform_real_distribution<double> uniform;
    PointSet set{2, {}};
    for (std::size_t i = 0; i < 2 * count; ++i) set.coordinates.push_back(uniform(random));
    return set;
}

/// Returns a rectangle in its frame, whose longest side is 1: the common areas have a closed form.
inline ClassPlace class_rectangle(double height)
{
    const PlaneRegion region{{{{{0, 0}, {1, 0}, {1, height}, {0, height}}}}};
    return ClassPlace(std::make_shared<const FramedRegion>(region, "rectangle"));
}

}
