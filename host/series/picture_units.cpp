#include "host/series/picture_units.hpp"

#include "base/files/whole_file.hpp"
#include "base/images/square_image_file.hpp"
#include "base/programs/interrupt.hpp"
#include "host/scenes/construction_run.hpp"
#include "results/file_names.hpp"
#include "results/pictures/archive.hpp"
#include "version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace poissonlab {
namespace {

std::string window_text(const CubeWindow& w)
{
    return fmt::format("{} {} {} {} {} {}", w.x, w.y, w.z, w.width, w.height, w.depth);
}

/// Tilings of the plane or of space without end: those that close repeat, and given ones are too small.
bool has_statistics(const TilingConfig& config)
{
    return !config.is_set() && config.request.period == Period{} && !config.request.is_given() &&
           config.request.kind != TileKind::domino;
}

std::map<std::string, std::string> image_metadata(const TilingConfig& config)
{
    const TilingRequest& request = config.request;
    return {{"algorithm", request.algorithm},
            {"colors", fmt::format("{}", request.colors)},
            {"seed", fmt::format("{}", request.seed)},
            {"version", POISSONLAB_VERSION_STRING}};
}

}

UnitKey PictureWork::key_of(const TilingTask& task) const
{
    const TilingConfig& config = task.config;
    const TilingRequest& request = config.request;
    return UnitKey("tiling")
        .add("code", versions_.pictures)
        .add("analysis code", versions_.analysis)
        .add("set", config.set)
        .add("kind", static_cast<int>(request.kind))
        .add("colors", request.colors)
        .add("vertical colors", request.vertical_colors)
        .add("algorithm", request.algorithm)
        .add("given", fmt::format("{}", fmt::join(request.given, " ")))
        .add("hash", static_cast<int>(request.hash))
        .add("seed", request.seed)
        .add("period", fmt::format("{} {} {}", request.period.x, request.period.y, request.period.z))
        .add("window", window_text(config.window));
}

UnitKey PictureWork::key_of(const ConstructionTask& task) const
{
    const ConstructionConfig& config = task.config;
    const PoissonTileParameters& p = config.parameters;
    const TileWindow& w = config.window;
    const Workplace& workplace = *experiment_.workplace;
    return UnitKey("construction")
        .add("code", versions_.pictures)
        .add("engine", experiment_.engine)
        .add("device", workplace.identity ? workplace.identity() : "")
        .add("tiles", fmt::format("{} {} {} {} {} {} {} {} {} {} {} {}", kind_name(p), p.dimension, p.colors, p.tiles,
                                  p.points_per_tile, p.relative_radius, static_cast<int>(p.filling), p.attempts,
                                  p.factor, p.lloyd_iterations, p.repulsion, p.seed))
        .add("show", config.show)
        .add("axes", config.axes)
        .add("variant", config.variant)
        .add("count", config.count)
        .add("modified", config.modified)
        .add("window", fmt::format("{} {} {} {}", w.x, w.y, w.width, w.height));
}

std::optional<TilingUnit> PictureWork::tiling(const TilingTask& task) const
{
    const auto unit = store_.find(key_of(task));
    if (!unit) return std::nullopt;
    TilingUnit stored;
    from_bytes(unit->record, stored.statistics);
    stored.files = unit->files;
    return stored;
}

void PictureWork::make_tiling(const TilingTask& task)
{
    if (tiling(task)) return;
    stop_if_interrupted();
    const UnitKey key = key_of(task);
    std::vector<std::string> files = {file_names::tiles};
    write_whole_file(store_.file(key, file_names::tiles), tiles_text(task.config));
    std::optional<TilingStatistics> statistics;
    if (has_statistics(task.config)) {
        statistics = tiling_statistics(task.config);
        for (const ColorStatistics& colors : statistics->colors) {
            files.push_back(autocorrelation_file(colors));
            write_square_image(store_.file(key, files.back()), {2 * statistics_lags + 1, colors.autocorrelation.z},
                               image_metadata(task.config));
        }
    }
    store_.store(key, to_bytes(statistics), files);
}

std::optional<ConstructionUnit> PictureWork::construction(const ConstructionTask& task) const
{
    const auto unit = store_.find(key_of(task));
    if (!unit) return std::nullopt;
    std::tuple<SceneSummary, bool> record;
    from_bytes(unit->record, record);
    return ConstructionUnit{std::get<SceneSummary>(record), std::get<bool>(record), unit->files};
}

bool PictureWork::are_constructions_there() const
{
    for (const ConstructionTask& task : experiment_.constructions)
        if (!construction(task)) return false;
    return true;
}

std::string PictureWork::identity() const
{
    std::string text;
    for (const TilingTask& task : experiment_.tilings) text += key_of(task).text();
    for (const ConstructionTask& task : experiment_.constructions) text += key_of(task).text();
    return text;
}

void PictureWork::make_constructions()
{
    std::vector<const ConstructionTask*> missing;
    std::vector<ConstructionConfig> configs;
    for (const ConstructionTask& task : experiment_.constructions) {
        if (construction(task)) continue;
        missing.push_back(&task);
        configs.push_back(task.config);
    }
    const Workplace& workplace = *experiment_.workplace;
    const std::vector<Scene> scenes = construct_scenes(configs, experiment_.make_filler, workplace.on_step);
    const bool on_device = workplace.is_device_open && workplace.is_device_open();
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const UnitKey key = key_of(*missing[i]);
        write_whole_file(store_.file(key, file_names::construction), scene_json(scenes[i]));
        store_.store(key, to_bytes(std::tuple(summary_of(scenes[i]), on_device)), {file_names::construction});
    }
}

}
