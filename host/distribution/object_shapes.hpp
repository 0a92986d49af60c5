// The looks of objects by name: their shapes, layers and colours.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 7.7 to 7.16; shapes by Gielis' superformula, A generic
// geometric transformation that unifies a wide range of natural and abstract shapes, 2003. Shapes are divided by their
// largest radius, to fit the unit disk.
#pragma once

#include "host/distribution/objects.hpp"
#include "host/settings/keys/choices.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// Gielis' radius in a direction, where a = b = 1 and n2 = n3 = n.
double superformula(double angle, double m, double n1, double n);

/// All shapes, in the order in which layers name them.
const ObjectShapes& object_shapes();

/// The names of looks in the plane, the default first, and in space.
const std::vector<std::string>& object_looks(int dimension);

/// The spread that a setting asks for, as kernels take it. Lengths are divided by `unit`.
contract::objects::Spread spread_of(const SpreadChoice& choice, double unit);

/// Sets layers, palette and background of a look. Throws std::logic_error for a name that is none.
void set_look(ObjectScene& scene, const std::string& look, int dimension);

}
