// PROJ brings some 35 libraries, for networks and pictures that it can read from, which take as long to load as all
// others of the program: it is in a module of its own.
#include "base/regions/globe/map_system.hpp"

#include "base/programs/loaded_module.hpp"
#include "base/regions/globe/globe_functions.hpp"

namespace poissonlab {
namespace {

const GlobeFunctions& globe()
{
    static const GlobeFunctions* const loaded = reinterpret_cast<GlobeFunctionsFunction>(
        function_of_module("poissonlab_globe", globe_functions_function, "longitude and latitude need PROJ"))();
    return *loaded;
}

}

MapSystem map_system(const std::string& text) { return globe().system(text); }

std::shared_ptr<const LocalPlane> local_plane(const MapSystem& system, std::array<double, 2> middle)
{
    return globe().plane(system, middle);
}

std::function<void(std::span<double> places)> system_change(const MapSystem& from, const MapSystem& to)
{
    return globe().change(from, to);
}

double ground_scale(const MapSystem& system, std::array<double, 2> place) { return globe().scale(system, place); }

}
