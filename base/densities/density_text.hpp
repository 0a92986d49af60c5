// A density as users type it: the name of a picture, or a formula.
#pragma once

#include "base/densities/density.hpp"

#include <string>

namespace poissonlab {

/// The density of the picture of that name, of which `from` is taken as by density_of_picture(), or of a formula over a
/// rectangle of these proportions. Throws InputError, one line, for what is neither, and for a `from` other than
/// "light" with a formula.
Density density_of_text(const std::string& text, const std::string& from, double width, double height);

}
