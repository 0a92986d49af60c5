// Files of SVG as shapes: what their elements go around, with the transforms of their groups.
//
// Expat reads the XML. Shapes that are not known, and what would change them (clipping, style sheets that place or hide
// them), are refused by name: the region would be another one than is seen. Colours, strokes and text in definitions do
// not matter.
#pragma once

#include "base/regions/svg/svg_shapes.hpp"

#include <2geom/affine.h>
#include <2geom/pathvector.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The shapes of a drawing, in the drawing's units, y upwards from the sheet's lower left corner.
std::vector<SvgShape> read_svg_drawing(const std::string& content, const std::string& name);

/// The attributes of an element; names of other namespaces begin with the namespace and a blank.
using SvgAttributes = std::map<std::string, std::string, std::less<>>;

/// Reads the map that a `transform` stands for, with places as rows: maps of inner groups come first. Returns nothing
/// where it cannot be understood.
std::optional<Geom::Affine> svg_transform(std::string_view text);

/// Numbers between blanks and commas; nothing where there is anything else.
std::optional<std::vector<double>> svg_numbers(std::string_view text);

/// A length in user units, 96 to an inch; nothing for percentages and other units.
std::optional<double> svg_length(std::string_view text);

/// The outline of a shape; nothing for other elements. Throws InputError, without a place, for attributes that are not
/// as they should be.
std::optional<Geom::PathVector> svg_outline(const std::string& element, const SvgAttributes& attributes);

}
