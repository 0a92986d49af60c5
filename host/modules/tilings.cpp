// Tilings as pictures: stochastic, aperiodic and isohedral ones, their constructions and schemes.
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"
#include "host/schemes/spherical_scheme.hpp"

#include <utility>

namespace poissonlab {

void add_tilings(Laboratory& laboratory)
{
    for (Kind& kind : construction_kinds()) laboratory.kinds.push_back(std::move(kind));
    for (Kind (*const kind)() :
         {tile_set_picture_kind, tiling_kind, printed_tiling_kind, corner_problem_kind, scanline_steps_kind,
          direct_scheme_kind, noise_kind, tiling_cost_kind, lattice_construction_kind, aperiodic_table_kind,
          diffraction_kind, isohedral_kind, substitution_kind, periodic_kind, brick_kind, surface_kind, spherical_kind,
          packing_kind, printed_packing_kind})
        laboratory.kinds.push_back(kind());
}

}
