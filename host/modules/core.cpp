// The core: sets of the unit torus, on which everything else stands.
#include "host/modules/laboratory.hpp"
#include "host/sampling/baselines.hpp"
#include "host/sampling/classics/candidate_darts.hpp"
#include "host/sampling/classics/command_sampler.hpp"
#include "host/sampling/classics/dense_packing.hpp"
#include "host/sampling/classics/low_discrepancy.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/file_sampler.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/optimized/equal_areas.hpp"
#include "host/sampling/optimized/farthest_point.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "host/sampling/optimized/target_spectrum.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "host/sampling/sectors/sector_darts.hpp"
#include "host/sampling/voronoi_darts.hpp"

namespace poissonlab {
namespace {

SamplerSpec in_plane(SamplerSpec spec)
{
    spec.dimensions = {2};
    return spec;
}

}

void add_core(Laboratory& laboratory)
{
    for (SamplerSpec (*const sampler)() : {random_sampler,
                                           regular_sampler,
                                           jittered_sampler,
                                           hexagonal_sampler,
                                           sobol_sampler,
                                           halton_sampler,
                                           best_candidate_sampler,
                                           bridson_sampler,
                                           dart_throwing_sampler,
                                           relaxation_dart_throwing_sampler,
                                           voronoi_dart_sampler,
                                           sector_dart_sampler,
                                           lloyd_sampler,
                                           sample_elimination_sampler,
                                           farthest_point_sampler,
                                           gaussian_blue_noise_sampler,
                                           target_spectrum_sampler,
                                           equal_areas_sampler,
                                           file_sampler,
                                           command_sampler})
        laboratory.samplers.push_back(sampler());
    laboratory.region_samplers = {in_plane(file_sampler()), in_plane(command_sampler())};
}

}
