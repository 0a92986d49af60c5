// The samplers "corner-tiles", "edge-tiles", "template-tiles" and "sphere-tiles": toroidal tilings with
// Poisson disk (sphere) tiles.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6 and 6.9 to 6.11, 6.15. All
// realizations are tilings with one tile set, which is built once and kept, see tile_set_cache.hpp.
#pragma once

#include "host/sampling/sampler.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

// Poisson disk tiles in a region of the plane, as sets of a series: see host/tile_points/tiled_region.hpp.
//
// Realizations are tilings of the plane with different seeds. Tiles are as wide as a minimum distance, or a number of
// points, asks for.

/// The sampler in regions of the tiles of a family of the plane, whose sampler on the torus is given.
SamplerSpec region_tile_sampler(const PoissonTileFamily& family, SamplerSpec on_torus);

// The samplers "shade-tiles" and "averaged-tiles": toroidal tilings of eight Wang tiles with points.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 6.6 and 6.7. All realizations are tilings with the
// same tiles, which the config's seed decides. Neither method promises a minimum distance of its tilings but the first.

SamplerSpec shade_tile_sampler();
SamplerSpec averaged_tile_sampler();

SamplerSpec corner_tile_sampler();
SamplerSpec edge_tile_sampler();
SamplerSpec template_tile_sampler();
SamplerSpec sphere_tile_sampler();

/// The parameters that tile sets of a family are made from, in the words of their sampler.
std::vector<ParameterSpec> tile_set_parameters(const PoissonTileFamily& family);

/// The tile set that such parameters ask for.
PoissonTileParameters tile_set_parameters_of(const PoissonTileFamily& family, const Parameters& given,
                                             std::uint64_t seed);

/// The tile set that one of these samplers builds, for tiles in the plane; nothing for any other sampler.
std::optional<PoissonTileParameters> plane_tile_set(const std::string& sampler, const Parameters& parameters,
                                                    std::uint64_t seed);

/// The tile sets of a series, and the part of their points that it keeps.
TileSetChoice tile_set_choice(const PoissonTileFamily& family, const Parameters& parameters,
                              const SampleRequest& request);

/// The place of a parameter in the config or, if its default holds, that of the tile set's size.
const SourceLocation& place_of_tile_parameter(const Parameters& parameters, const std::string& key,
                                              const PoissonTileFamily& family);

/// The parameter "sets", the number of tile sets that realizations take in turn.
ParameterSpec tile_sets_parameter();

/// The side of the toroidal tiling whose number of points is nearest to `points`, in tiles; at least 1. Tiles of which
/// only a part of the points is kept have that many on average.
std::uint32_t tiling_side(std::size_t points, double points_per_tile, int dimension);

}
