// A density as users type it: the name of a picture, or a formula.
//
// Densities as formulas in x and y.
#pragma once

#include "base/densities/density.hpp"

#include <string>

namespace poissonlab {

/// The density of the picture of that name, of which `from` is taken as by density_of_picture(), or of a formula over a
/// rectangle of these proportions. Throws InputError, one line, for what is neither, and for a `from` other than
/// "light" with a formula.
Density density_of_text(const std::string& text, const std::string& from, double width, double height);

/// The pixels of a formula's longest side.
inline constexpr int formula_pixels = 1024;

/// The formula of a name, or the text itself. Named is "gauss-and-waves", exp(-20(x^2+y^2)) + 0.05 sin^2(pi x)
/// sin^2(pi y): Lagae, Tile-Based Methods in Computer Graphics, 2007, figure 4.44.
std::string formula_of(const std::string& name_or_text);

/// The density of a formula over a rectangle of these proportions: x and y are -1 to 1 along its longest side, 0 in its
/// middle; values are those in the middles of pixels. Knows + - * / ^, comparisons, `condition ? a : b`, pi, e, sqrt,
/// exp, ln, sin, cos and the like. Throws InputError, one line with the formula, for one that cannot be understood and
/// for what density_of_values() refuses.
Density density_of_formula(const std::string& formula, double width, double height);

}
