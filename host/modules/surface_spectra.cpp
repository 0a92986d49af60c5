// Spectra of points on surfaces.
#include "host/distribution/surface_spectra/mesh_set.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_surface_spectra(Laboratory& laboratory) { laboratory.kinds.push_back(mesh_set_kind()); }

}
