// The tile sets of a series, which its realizations take in turn.
#pragma once

#include "host/sampling/sampler.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// So many sets, with seeds that follow one another.
struct TileSetChoice
{
    PoissonTileParameters first;
    std::uint32_t sets = 1;
    double density = 1; ///< part of the points that is kept
};

/// How many tile sets a series has: its parameter `sets`.
std::uint32_t sets_of(const Parameters& given);

class SeriesTileSets
{
public:
    /// Takes them from the cache, or builds them. Throws InputError where the relative radius cannot be reached.
    SeriesTileSets(const TileSetChoice& choice, const SampleRequest& request, Engine engine,
                   const DeviceProvider& device);

    const std::vector<PoissonTileSet>& all() const { return sets_; }

    /// Returns what sets of points have of their tile sets; its tile_set_file is to be called while this lives.
    SetTraits traits() const;

private:
    double preparation_seconds_ = 0;
    std::vector<PoissonTileSet> sets_;
    TileSetRecord record_; ///< of the first
};

}
