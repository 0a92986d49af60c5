#include "host/settings/sampler_registry.hpp"

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
#include "host/tile_sampling/isohedral/isohedral_sampler.hpp"
#include "host/tile_sampling/penrose/penrose_sampler.hpp"
#include "host/tile_sampling/polyominoes/polyomino_sampler.hpp"
#include "host/tile_sampling/recursive/recursive_sampler.hpp"
#include "host/tile_sampling/tile_samplers.hpp"
#include "host/tile_sampling/wang_tiles/wang_samplers.hpp"

#include <algorithm>

namespace poissonlab {

const SamplerRegistry& sampler_registry()
{
    // clang-format off
    static const SamplerRegistry registry = {
        random_sampler(),
        regular_sampler(),
        jittered_sampler(),
        hexagonal_sampler(),
        sobol_sampler(),
        halton_sampler(),
        best_candidate_sampler(),
        bridson_sampler(),
        dart_throwing_sampler(),
        relaxation_dart_throwing_sampler(),
        voronoi_dart_sampler(),
        sector_dart_sampler(),
        lloyd_sampler(),
        sample_elimination_sampler(),
        farthest_point_sampler(),
        gaussian_blue_noise_sampler(),
        target_spectrum_sampler(),
        equal_areas_sampler(),
        corner_tile_sampler(),
        edge_tile_sampler(),
        template_tile_sampler(),
        sphere_tile_sampler(),
        shade_tile_sampler(),
        averaged_tile_sampler(),
        penrose_sampler(),
        recursive_wang_tile_sampler(),
        polyomino_sampler(),
        isohedral_tile_sampler(),
        file_sampler(),
        command_sampler(),
    };
    // clang-format on
    return registry;
}

const SamplerSpec* find_sampler(const std::string& name, const SamplerRegistry& registry)
{
    const auto found = std::ranges::find(registry, name, &SamplerSpec::name);
    return found == registry.end() ? nullptr : &*found;
}

const ParameterSpec& parameter_of(const std::string& sampler, const std::string& key)
{
    return *std::ranges::find(find_sampler(sampler)->parameters, key, &ParameterSpec::key);
}

}
