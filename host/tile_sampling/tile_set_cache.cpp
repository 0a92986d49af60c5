#include "host/tile_sampling/tile_set_cache.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "base/programs/cache_folder.hpp"
#include "code_hashes.hpp"
#include "host/tile_construction/chain_construction.hpp"
#include "host/tile_construction/classes/class_construction.hpp"
#include "host/tile_construction/tile_ranking.hpp"
#include "host/tile_sampling/built_once.hpp"
#include "tiles/poisson/counts/shared_points.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/region_counts.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace poissonlab {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

using SetAndBuild = std::pair<PoissonTileSet, std::optional<TileSetBuild>>;

std::optional<SetAndBuild> stored_set(const std::filesystem::path& file, const PoissonTileParameters& parameters)
{
    PoissonTileSet set = read_tile_set(file);
    if (set.parameters != parameters || set.squared_min_distance < asked_squared_distance(parameters))
        return std::nullopt;
    return SetAndBuild{std::move(set), read_build_record(file)};
}

void store_set(const std::filesystem::path& file, const SetAndBuild& built)
{
    std::filesystem::remove(build_record_file(file)); // of an earlier set, which the new one must not be taken for
    write_tile_set(file, built.first);
    write_build_record(file, *built.second);
}

/// Builds a set and takes the time.
SetAndBuild timed_build(const PoissonTileParameters& parameters, Engine engine, const DeviceProvider& device,
                        const std::function<void(const std::string& what)>& on_step)
{
    ConstructionOptions options;
    if (on_step)
        options.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
            on_step(fmt::format("{} Poisson tiles: {} {} of {}", kind_name(parameters), stage, done, total));
        };
    TileSetBuild build;
    Device* const opened = engine == Engine::opencl ? &device() : nullptr;
    const auto compile_seconds = [&] { return opened ? opened->build_seconds() : 0.0; };
    if (opened) build.device = opened->info().name;
    build.threads = static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
    const double compiled_before = compile_seconds();
    const auto begin = Clock::now();
    PoissonTileSet set = build_tile_set(
                             parameters, engine, [=]() -> Device& { return *opened; }, options)
                             .set;
    build.seconds = std::max(0.0, seconds_since(begin) - (compile_seconds() - compiled_before));
    return {std::move(set), std::move(build)};
}

/// Templates have no regions of corners and edges, and chains are no regions.
std::vector<RegionPoints> region_points(const PoissonTileSet& set)
{
    std::vector<RegionPoints> points;
    if (set.parameters.kind == PoissonTileKind::frame || set.parameters.border == TileBorder::chain) return points;
    const std::vector<const char*> names = set.parameters.dimension == 2
                                               ? std::vector{"corners", "edges", "interior"}
                                               : std::vector{"corners", "edges", "faces", "interior"};
    const auto counts = region_counts(set);
    for (std::size_t i = 0; i < names.size(); ++i) points.push_back({names[i], counts[i].mean, counts[i].expected});
    return points;
}

CachedTileSet recorded(PoissonTileSet set, bool cached, std::optional<TileSetBuild> build, double waiting_seconds)
{
    TileSetRecord record{
        set.parameters.tiles, set.parameters.points_per_tile, cached, std::move(build), region_points(set),
        shared_points(set)};
    return {std::move(set), std::move(record), waiting_seconds};
}

}

ConstructedTileSet build_tile_set(const PoissonTileParameters& parameters, Engine engine, const DeviceProvider& device,
                                  const ConstructionOptions& options)
{
    check(parameters);
    const auto filler = [&](const FillSettings& settings) {
        return engine == Engine::opencl ? make_tile_filler(settings, device()) : reference::make_tile_filler(settings);
    };
    const auto joint_engine = [&] {
        return engine == Engine::opencl ? make_joint_engine(parameters.dimension, device())
                                        : reference::make_joint_engine(parameters.dimension);
    };
    ConstructedTileSet built;
    if (!parameters.classes.is_empty()) {
        const ClassFillSettings settings = class_fill_settings(parameters);
        const auto classes = engine == Engine::opencl ? make_class_tile_filler(settings, device())
                                                      : reference::make_class_tile_filler(settings);
        const auto joint = are_relaxed_together(parameters) ? joint_engine() : nullptr;
        built = construct_class_tiles(parameters, *classes, options, joint.get());
    } else if (parameters.border == TileBorder::chain) {
        const auto tori = filler(chain_torus_settings(parameters));
        const auto interiors = filler(chain_interior_settings(parameters));
        const auto joint = joint_engine();
        built = construct_chain_tiles(parameters, {*tori, *interiors, *joint}, options);
    } else if (are_relaxed_together(parameters)) {
        const auto pieces = filler(fill_settings(parameters)), mender = filler(mending_settings(parameters));
        const auto joint = joint_engine();
        const JointEngines together{*mender, *joint};
        built = construct_tile_set(parameters, *pieces, options, &together);
    } else {
        built = construct_tile_set(parameters, *filler(fill_settings(parameters)), options);
    }
    if (parameters.ranked)
        built.set.ranks = rank_points(built.set, [&](std::size_t done, std::size_t total) {
            if (options.progress) options.progress("ranks", done, total);
        });
    const TileCertificate certificate = certify(built.set);
    built.set.squared_min_distance = certificate.squared_min_distance;
    for (std::size_t pair = 0; pair < certificate.classes.size(); ++pair)
        built.set.class_squared_distances[pair] = certificate.classes[pair].squared_min_distance;
    check_class_promises(parameters.classes, built.set.class_squared_distances, certificate.classes);
    if (built.set.squared_min_distance < asked_squared_distance(parameters))
        throw std::logic_error("a tile set was built whose tilings do not keep the minimum distance");
    return built;
}

DeviceMemory build_memory(const PoissonTileParameters& parameters, const DeviceInfo& device)
{
    return parameters.classes.is_empty() ? construction_memory(parameters, device)
                                         : class_construction_memory(parameters);
}

std::string tile_cache_name(const PoissonTileParameters& p, const DeviceInfo* device)
{
    // Names of devices are long, and hold what file names may not.
    const std::string maker =
        device ? fmt::format("opencl-{:08x}", xxh64_bytes(device->identity()) & 0xFFFFFFFFU) : "reference";
    const std::string joint =
        p.joint_iterations > 0 ? fmt::format("-joint{}{}", p.joint_iterations, p.null_peaks ? "-nulled" : "") : "";
    const std::string moments = p.equal_moments > 0 ? fmt::format("-moments{}", p.equal_moments) : "";
    return fmt::format("{}-{}{}-n{}-rho{}-{}-{}x{}-lloyd{}{}{}{}{}{}-seed{}-{}-{}.ptiles", kind_name(p),
                       p.kind == PoissonTileKind::frame ? "t" : "c",
                       p.kind == PoissonTileKind::frame ? p.tiles : p.colors, p.points_per_tile, p.relative_radius,
                       p.filling == TileFilling::dart_throwing ? "darts" : "relaxation", p.attempts, p.factor,
                       p.lloyd_iterations, p.repulsion ? "-repulsion" : "",
                       p.border == TileBorder::chain ? "-chains" : "", joint, moments, p.ranked ? "-ranked" : "",
                       p.seed, maker, POISSONLAB_CONSTRUCTION_VERSION);
}

CachedTileSet cached_tile_set(const PoissonTileParameters& parameters, Engine engine, const DeviceProvider& device,
                              const std::filesystem::path& folder,
                              const std::function<void(const std::string& what)>& on_step)
{
    const DeviceInfo* const info = engine == Engine::opencl ? &device().info() : nullptr;
    auto once = built_once(
        folder.empty() ? folder : folder / tile_cache_name(parameters, info), on_step,
        [&](const std::filesystem::path& file) { return stored_set(file, parameters); },
        [&] { return timed_build(parameters, engine, device, on_step); }, store_set);
    auto& [set, build] = once.built;
    return recorded(std::move(set), once.cached, std::move(build), once.waiting_seconds);
}

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

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "poissonlab-tile-set-build";

}

std::filesystem::path build_record_file(const std::filesystem::path& tile_set_file)
{
    return tile_set_file.string() + ".json";
}

void write_build_record(const std::filesystem::path& tile_set_file, const TileSetBuild& build)
{
    const Json json = {{"format", format_name},
                       {"format_version", 1},
                       {"build_seconds", build.seconds},
                       {"device", build.device},
                       {"threads", build.threads}};
    write_whole_file(build_record_file(tile_set_file), json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<TileSetBuild> read_build_record(const std::filesystem::path& tile_set_file)
{
    const std::filesystem::path file = build_record_file(tile_set_file);
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    try {
        const Json json = Json::parse(read_whole_file(file));
        if (json.at("format") != format_name || json.at("format_version") != 1) return std::nullopt;
        const TileSetBuild build{json.at("build_seconds"), json.at("device"), json.at("threads")};
        if (!std::isfinite(build.seconds) || build.seconds < 0 || build.threads < 1) return std::nullopt;
        return build;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}
