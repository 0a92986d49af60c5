// This module has sets by tiles that chapter 6 compares with Poisson disk tiles, Penrose's, polyominoes, isohedral and
// recursive ones, and sets by aperiodic monotiles and dodecagonal tilings.
#include "host/modules/laboratory.hpp"
#include "host/tile_sampling/dodecagonal/dodecagonal_sampler.hpp"
#include "host/tile_sampling/isohedral/isohedral_sampler.hpp"
#include "host/tile_sampling/monotiles/monotile_sampler.hpp"
#include "host/tile_sampling/monotiles/region_monotile_sampler.hpp"
#include "host/tile_sampling/penrose/penrose_sampler.hpp"
#include "host/tile_sampling/polyominoes/polyomino_sampler.hpp"
#include "host/tile_sampling/recursive/recursive_sampler.hpp"

namespace poissonlab {

void add_other_tiles(Laboratory& laboratory)
{
    for (SamplerSpec (*const sampler)() : {penrose_sampler, dodecagonal_sampler, recursive_wang_tile_sampler,
                                           polyomino_sampler, isohedral_tile_sampler, hat_sampler, spectre_sampler})
        laboratory.samplers.push_back(sampler());
    laboratory.region_samplers.push_back(region_monotile_sampler("hat", hat_sampler()));
    laboratory.region_samplers.push_back(region_monotile_sampler("spectre", spectre_sampler()));
}

}
