#include "host/sampling/dart_sampler.hpp"
#include "host/sampling/voronoi_darts.hpp"

namespace poissonlab {

SamplerSpec voronoi_dart_sampler()
{
    return dart_sampler({.name = "voronoi-darts",
                         .title = "Voronoi darts",
                         .summary = "dart throwing into what disks leave of Voronoi cells, by area (Jones)",
                         .dimensions = {2},
                         .purpose = Purpose::voronoi_darts,
                         .kernels = {"voronoi_darts.cl"},
                         .memory = VoronoiDarts::memory,
                         .thrower = thrower_by<VoronoiDarts, reference::throw_voronoi_darts>});
}

}
