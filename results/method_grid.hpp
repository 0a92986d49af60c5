// The series of a config as grids: one grid a [[method]], one axis a list of values.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// A parameter of a method that takes several values.
struct MethodAxis
{
    std::string key;
    std::string symbol;              ///< as names and labels of series have it: "rho" for "relative_radius"
    std::vector<std::string> values; ///< as shown; at least two

    bool operator==(const MethodAxis&) const = default;
};

/// A [[method]], over its axes in the order in which they vary, the last one fastest.
struct MethodGrid
{
    std::string sampler;
    std::string label;            ///< the user's; empty: none was given
    std::vector<MethodAxis> axes; ///< none: the method is one series

    bool operator==(const MethodGrid&) const = default;
};

/// The place of a series in the grid of its method.
struct GridPlace
{
    std::size_t method = 0;           ///< of the config, counted from 0
    std::vector<std::size_t> indices; ///< of its value on each axis

    bool operator==(const GridPlace&) const = default;
};

}
