#include "host/distribution/region_samplers/region_samplers.hpp"

#include "host/distribution/region_samplers/region_method_samplers.hpp"
#include "host/sampling/classics/command_sampler.hpp"
#include "host/sampling/file_sampler.hpp"
#include "host/tile_sampling/region_tile_sampler.hpp"
#include "host/tile_sampling/tile_samplers.hpp"

namespace poissonlab {

namespace {

SamplerSpec in_plane(SamplerSpec spec)
{
    spec.dimensions = {2};
    return spec;
}

}

const SamplerRegistry& region_sampler_registry()
{
    static const SamplerRegistry registry = {
        region_random_sampler(),
        region_bridson_sampler(),
        region_dart_sampler(),
        region_relaxation_sampler(),
        region_lloyd_sampler(),
        region_elimination_sampler(),
        region_gaussian_sampler(),
        region_tile_sampler({PoissonTileKind::corner, 2}, corner_tile_sampler()),
        region_tile_sampler({PoissonTileKind::edge, 2}, edge_tile_sampler()),
        region_tile_sampler({PoissonTileKind::frame, 2}, template_tile_sampler()),
        in_plane(file_sampler()),
        in_plane(command_sampler()),
    };
    return registry;
}

}
