// Poisson disk tiles: corner, edge, template and sphere tiles, Shade's and averaged ones.
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"
#include "host/tile_sampling/tile_samplers.hpp"

namespace poissonlab {

void add_tiles(Laboratory& laboratory)
{
    for (SamplerSpec (*const sampler)() : {corner_tile_sampler, edge_tile_sampler, template_tile_sampler,
                                           sphere_tile_sampler, shade_tile_sampler, averaged_tile_sampler})
        laboratory.samplers.push_back(sampler());
    laboratory.region_samplers.push_back(region_tile_sampler({PoissonTileKind::corner, 2}, corner_tile_sampler()));
    laboratory.region_samplers.push_back(region_tile_sampler({PoissonTileKind::edge, 2}, edge_tile_sampler()));
    laboratory.region_samplers.push_back(region_tile_sampler({PoissonTileKind::frame, 2}, template_tile_sampler()));
    laboratory.kinds.push_back(tile_set_kind());
}

}
