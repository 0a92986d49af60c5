#include "host/tile_sampling/series_tile_sets.hpp"

#include "base/programs/cache_folder.hpp"
#include "host/device/device.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <chrono>
#include <utility>

namespace poissonlab {

std::uint32_t sets_of(const Parameters& given) { return static_cast<std::uint32_t>(given.integer("sets")); }

SeriesTileSets::SeriesTileSets(const TileSetChoice& choice, const SampleRequest& request, Engine engine,
                               const DeviceProvider& device)
{
    const auto begin = std::chrono::steady_clock::now();
    const double built_before = engine == Engine::opencl ? device().build_seconds() : 0;
    double waiting_seconds = 0;
    for (std::uint32_t i = 0; i < choice.sets; ++i) {
        PoissonTileParameters parameters = choice.first;
        parameters.seed += i;
        CachedTileSet cached = cached_tile_set(parameters, engine, device, cache_folder(), request.on_step);
        sets_.push_back(std::move(cached.set));
        if (i == 0) record_ = std::move(cached.record);
        waiting_seconds += cached.waiting_seconds;
    }
    const std::chrono::duration<double> all = std::chrono::steady_clock::now() - begin;
    const double built = engine == Engine::opencl ? device().build_seconds() - built_before : 0;
    preparation_seconds_ = all.count() - built - waiting_seconds;
}

SetTraits SeriesTileSets::traits() const
{
    SetTraits traits;
    traits.tile_sets = static_cast<std::uint32_t>(sets_.size());
    traits.tile_set = record_;
    traits.tile_set_file = [this] { return encode_tile_set(sets_.front()); };
    traits.preparation_seconds = preparation_seconds_;
    return traits;
}

}
