// Methods of the unit torus that the core does without: lattices and sequences, classics, other kinds of darts, and
// methods that optimise sets.
#include "host/modules/laboratory.hpp"
#include "host/sampling/classics/candidate_darts.hpp"
#include "host/sampling/classics/dense_packing.hpp"
#include "host/sampling/classics/low_discrepancy.hpp"
#include "host/sampling/classics/voronoi_darts.hpp"
#include "host/sampling/optimized/equal_areas.hpp"
#include "host/sampling/optimized/farthest_point.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "host/sampling/optimized/target_spectrum.hpp"
#include "host/sampling/sectors/sector_darts.hpp"

namespace poissonlab {

void add_methods(Laboratory& laboratory)
{
    for (SamplerSpec (*const sampler)() :
         {hexagonal_sampler, sobol_sampler, halton_sampler, best_candidate_sampler, bridson_sampler,
          voronoi_dart_sampler, sector_dart_sampler, sample_elimination_sampler, farthest_point_sampler,
          gaussian_blue_noise_sampler, target_spectrum_sampler, equal_areas_sampler})
        laboratory.samplers.push_back(sampler());
}

}
