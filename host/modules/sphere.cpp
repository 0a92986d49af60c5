// Points on the sphere by polyominoes.
#include "host/distribution/sphere/sphere_set.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_sphere(Laboratory& laboratory) { laboratory.kinds.push_back(sphere_kind()); }

}
