// Kinds of distributions have these in common: densities and methods of even points as settings say them.
#pragma once

#include "host/distribution/even_points.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/settings/keys/choices.hpp"

#include <string>

namespace poissonlab {

/// The density that a config's choice says; formulas are over a square.
Density chosen_density(const DensityChoice& choice);

/// The method of even points that it says. Reads the tile set's file.
EvenMethod chosen_method(const EvenMethodChoice& choice);

/// "corner-tiles" or the file's name, for facts.
std::string method_words(const EvenMethodChoice& choice);

}
