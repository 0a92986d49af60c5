#include "host/scenes/construction_run.hpp"

#include "base/programs/interrupt.hpp"
#include "host/device/device.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"

#include <fmt/format.h>

#include <set>

namespace poissonlab {
namespace {

/// Thrown by a construction once all that is shown has been made.
struct AllIsMade
{
};

MadeTiles make_tiles(const ShownConstruction& shown, const DistributionPlace& place)
{
    const PoissonTileParameters& parameters = shown.parameters;
    const std::vector<PieceKey> keys = shown.is_set() ? std::vector<PieceKey>{} : wanted_pieces(shown);
    const std::set<PieceKey> wanted(keys.begin(), keys.end());
    MadeTiles made;
    if (wanted.empty() && !shown.is_tiling()) return made;
    ConstructionOptions options;
    options.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
        stop_if_interrupted();
        if (place.on_step)
            place.on_step(fmt::format("{} Poisson tiles: {} {} of {}", kind_name(parameters), stage, done, total));
    };
    // Pieces that are made again replace those before.
    options.record = [&](const ConstructionRecord& record) {
        const PieceKey key{record.axes, record.variant};
        if (!wanted.contains(key)) return;
        made.pieces[key] = {record.base, record.held, *record.problem, *record.filled};
        if (!shown.is_tiling() && made.pieces.size() == wanted.size()) throw AllIsMade{};
    };
    try {
        made.set = build_tile_set(parameters, place.engine, place.device, options).set;
    } catch (const AllIsMade&) {
    }
    return made;
}

}

Scene construct_scene(const ShownConstruction& shown, const DistributionPlace& place)
{
    return make_scene(shown, make_tiles(shown, place));
}

}
