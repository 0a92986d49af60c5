// Points of a part of a set, with their numbers in the set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

struct NumberedPoints
{
    std::vector<double> coordinates; ///< dimension values a point, in [0, 1)
    std::vector<std::uint32_t> ids;

    std::size_t size() const { return ids.size(); }

    void add(std::span<const double> place, std::uint32_t id)
    {
        coordinates.insert(coordinates.end(), place.begin(), place.end());
        ids.push_back(id);
    }

    void clear()
    {
        coordinates.clear();
        ids.clear();
    }
};

}
