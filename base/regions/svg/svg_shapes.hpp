// Drawings and paths of SVG as shapes, which the module poissonlab_drawings reads: lib2geom and Expat, with the
// libraries that they bring, take 10 ms to load, and few commands read drawings.
#pragma once

#include "base/regions/plane_region.hpp"

#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// The lines that an element of a drawing, or the data of a path, draws.
struct SvgShape
{
    std::string place; ///< "drawing.svg:12: <path>", for messages
    bool is_even_odd = false;
    RegionBox box; ///< holds ends, control points and arcs; without any it is the origin
    /// Returns the lines of paths; those that are closed end where they begin. Throws InputError where curves take too
    /// many lines.
    std::function<std::vector<RegionRing>(double tolerance)> lines;
};

/// The functions of the module.
struct DrawingFunctions
{
    /// The shapes of a drawing in the order of the file. Throws InputError, a line that begins with the name and the
    /// line's number.
    std::vector<SvgShape> (*drawing)(const std::string& content, const std::string& name);
    /// Reads the data of a path, `M 0 0 L 1 0 ...`. Throws InputError, which begins with the name.
    SvgShape (*path)(const std::string& data, const std::string& name);
};

/// The function of the module that returns these.
using DrawingFunctionsFunction = const DrawingFunctions* (*)();
inline constexpr const char* drawing_functions_function = "poissonlab_drawing_functions";

}
