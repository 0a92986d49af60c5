// A region's text, or the file of this name, before anything is made of it.
#pragma once

#include "base/regions/formats/region_shapes.hpp"

#include <string>

namespace poissonlab {

/// The kinds of texts.
enum class TypedKind
{
    unknown, ///< none of them
    shape,   ///< a rectangle, a disk, a formula, a path or drawing of SVG, a picture
    json,
    wkt
};

struct TypedRegion
{
    /// Reads it. With `is_along` paths of SVG are lines, which need not be closed. Throws InputError.
    explicit TypedRegion(const std::string& text, bool is_along = false);

    bool is_json() const { return kind == TypedKind::json; }
    bool is_wkt() const { return kind == TypedKind::wkt; }

    std::string name; ///< what messages call it
    TypedKind kind = TypedKind::unknown;
    RegionShapes shapes;
};

/// The words of a message on what is no region.
extern const char* const no_region;

/// The box around all of its points, lines and polygons.
RegionBox box_of_all(const Obstacles& shapes);

}
