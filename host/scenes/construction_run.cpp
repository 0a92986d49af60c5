#include "host/scenes/construction_run.hpp"

#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace poissonlab {
namespace {

/// Thrown by a construction once all that is shown has been made.
struct AllIsMade
{
};

/// The pieces that the configs with the same parameters show, and whether one of them shows a tiling.
struct Wanted
{
    std::set<PieceKey> pieces;
    bool whole_set = false;
};

Wanted wanted_of(std::span<const ConstructionConfig> configs, const PoissonTileParameters& parameters)
{
    Wanted wanted;
    for (const ConstructionConfig& config : configs) {
        if (!(config.parameters == parameters)) continue;
        const std::vector<PieceKey> pieces = wanted_pieces(config);
        wanted.pieces.insert(pieces.begin(), pieces.end());
        wanted.whole_set = wanted.whole_set || config.is_tiling();
    }
    return wanted;
}

MadeTiles make_tiles(const PoissonTileParameters& parameters, const Wanted& wanted, const FillerFactory& make_filler,
                     const std::function<void(const std::string&)>& progress)
{
    MadeTiles made;
    if (wanted.pieces.empty() && !wanted.whole_set) return made;
    ConstructionOptions options;
    options.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
        stop_if_interrupted();
        if (progress) progress(fmt::format("{} Poisson tiles: {} {} of {}", kind_name(parameters), stage, done, total));
    };
    // Pieces that are made again replace those before.
    options.record = [&](const ConstructionRecord& record) {
        const PieceKey key{record.axes, record.variant};
        if (!wanted.pieces.contains(key)) return;
        made.pieces[key] = {record.base, record.held, *record.problem, *record.filled};
        if (!wanted.whole_set && made.pieces.size() == wanted.pieces.size()) throw AllIsMade{};
    };
    try {
        const auto filler = make_filler(fill_settings(parameters));
        made.set = construct_tile_set(parameters, *filler, options).set;
    } catch (const AllIsMade&) {
    }
    return made;
}

}

std::vector<Scene> construct_scenes(std::span<const ConstructionConfig> configs, const FillerFactory& make_filler,
                                    const std::function<void(const std::string&)>& progress)
{
    std::vector<Scene> scenes(configs.size());
    std::vector<bool> done(configs.size());
    for (std::size_t first = 0; first < configs.size(); ++first) {
        if (done[first]) continue;
        const PoissonTileParameters& parameters = configs[first].parameters;
        try {
            const MadeTiles made = make_tiles(parameters, wanted_of(configs, parameters), make_filler, progress);
            for (std::size_t i = first; i < configs.size(); ++i) {
                if (!(configs[i].parameters == parameters)) continue;
                scenes[i] = make_scene(configs[i], made);
                done[i] = true;
            }
        } catch (const InputError& error) {
            throw error.moved_to(configs[first].where);
        }
    }
    return scenes;
}

}
