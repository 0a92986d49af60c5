// The functions by which this room calls the module with PROJ, the library of systems of coordinates: see
// map_system.hpp for what they do.
#pragma once

#include "base/regions/globe/map_system.hpp"

namespace poissonlab {

/// The functions of the module, each as that of its longer name in the room.
struct GlobeFunctions
{
    MapSystem (*system)(const std::string& text);
    std::shared_ptr<const LocalPlane> (*plane)(const MapSystem& system, std::array<double, 2> middle);
    std::function<void(std::span<double> places)> (*change)(const MapSystem& from, const MapSystem& to);
    double (*scale)(const MapSystem& system, std::array<double, 2> place);
};

/// The function of the module that returns these.
using GlobeFunctionsFunction = const GlobeFunctions* (*)();
inline constexpr const char* globe_functions_function = "poissonlab_globe_functions";

}
