// poissonlab tiles build: constructs a Poisson disk (sphere) tile set, proves its minimum distance, and
// writes it.
#include "app/commands/command.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/config/nearest_key.hpp"
#include "host/config/parameter_values.hpp"
#include "host/config/sampler_help.hpp"
#include "host/config/sampler_registry.hpp"
#include "host/run/progress.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <system_error>

#include <unistd.h>

namespace poissonlab {
namespace {

constexpr auto tiles_build_notes =
    R"(corner: C^4 tiles; edge: C^12; sphere: C^8 in three dimensions; template: T tiles. Lloyd relaxation alone is good
for relative radii up to 0.75, with --repulsion 0.85 can be had. The file is described in docs/tile-set-file.md.
  poissonlab tiles build corner --colors 4 --points 64 --out corner.ptiles
  poissonlab tiles build corner --colors 4 --points 64 --border chain --out seamless.ptiles
  poissonlab tiles build template --tiles 16 --points 32 --relative-radius 0.8 --repulsion --out template.ptiles)";

/// The sampler of the same tiles, whose defaults and ranges these options have as well.
constexpr auto sampler = "corner-tiles";

const Parameters& otherwise()
{
    static const Parameters defaults(find_sampler(sampler)->parameters);
    return defaults;
}

constexpr std::uint32_t not_given = UINT32_MAX;

/// The option with the values that the samplers' parameter of this key takes.
Option as_parameter(Option option, const std::string& key)
{
    return allowing(std::move(option), allowed_values(parameter_of(key == "tiles" ? "template-tiles" : sampler, key)));
}

struct TilesBuildOptions
{
    std::string kind; ///< "corner", "edge", "template" or "sphere"
    std::uint32_t colors = 0;
    std::uint32_t tiles = 0; ///< of template tiles
    std::uint32_t points = 0;
    double relative_radius = otherwise().number("relative_radius");
    std::string filling = otherwise().text("filling");
    std::uint32_t lloyd_iterations = static_cast<std::uint32_t>(otherwise().integer("lloyd_iterations"));
    bool repulsion = false;
    std::string border = otherwise().text("border");
    std::uint32_t joint_iterations = not_given;
    std::string null_peaks; ///< "on" or "off"; empty: not given
    std::uint32_t equal_moments = not_given;
    bool ranked = false;
    std::uint64_t seed = 1;
    std::filesystem::path out;
    std::string engine = "opencl";
    std::string device;
    bool quiet = false;
};

void check_word(const std::string& what, const std::string& word, const std::vector<std::string>& known)
{
    if (std::ranges::find(known, word) == known.end())
        throw InputError(fmt::format("tiles build: {} \"{}\": unknown{} (known: {})", what, word,
                                     did_you_mean(word, known), fmt::join(known, ", ")));
}

PoissonTileParameters checked_parameters(const TilesBuildOptions& o)
{
    check_word("kind", o.kind, poisson_tile_families.all());
    check_word("--filling", o.filling, tile_fillings.all());
    check_word("--engine", o.engine, engines.all());
    check_word("--border", o.border, tile_borders.all());
    if (!o.null_peaks.empty()) check_word("--null-peaks", o.null_peaks, {"on", "off"});
    const ParameterSpec& lloyd = parameter_of(sampler, "lloyd_iterations");
    if (o.lloyd_iterations > lloyd.maximum)
        throw invalid_value({"tiles build"}, "--lloyd", fmt::format("{}", o.lloyd_iterations),
                            "must be " + allowed_values(lloyd));
    const bool is_template = o.kind == "template";
    if (is_template ? o.colors != 0 || o.tiles == 0 : o.tiles != 0 || o.colors == 0)
        throw InputError(fmt::format("tiles build: {} tiles need {} and have no {}", o.kind,
                                     is_template ? "--tiles" : "--colors", is_template ? "--colors" : "--tiles"));
    PoissonTileParameters p;
    const PoissonTileFamily family = *poisson_tile_families.find(o.kind);
    p.kind = family.kind;
    p.dimension = family.dimension;
    p.colors = is_template ? 1 : o.colors;
    p.tiles = is_template ? o.tiles : tile_count(p.kind, p.dimension, p.colors);
    p.points_per_tile = o.points;
    p.relative_radius = o.relative_radius;
    if (tile_fillings.find(o.filling) == TileFilling::dart_throwing) set_dart_throwing(p);
    p.lloyd_iterations = o.lloyd_iterations;
    p.repulsion = o.repulsion;
    const auto if_given = [](std::uint32_t value) { return value == not_given ? std::nullopt : std::optional(value); };
    set_border(p, *tile_borders.find(o.border), if_given(o.joint_iterations),
               o.null_peaks.empty() ? std::nullopt : std::optional(o.null_peaks == "on"), if_given(o.equal_moments));
    p.ranked = o.ranked;
    p.seed = o.seed;
    try {
        check(p);
    } catch (const InputError& error) {
        throw error.moved_to({"tiles build"});
    }
    return p;
}

/// Building takes up to minutes, which a file that cannot be written would waste.
void check_target(const std::filesystem::path& file)
{
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code unknown;
    if (!std::filesystem::is_directory(folder, unknown))
        throw InputError(fmt::format("tiles build: --out {}: there is no folder {}", file.string(), folder.string()));
    if (std::filesystem::is_directory(file, unknown))
        throw InputError(fmt::format("tiles build: --out {}: is a folder", file.string()));
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw StorageError(fmt::format("tiles build: --out {}: cannot be written: {}", file.string(),
                                       std::generic_category().message(errno)));
}

void check_memory(const PoissonTileParameters& parameters, const DeviceInfo& device)
{
    check_fits(fmt::format("tiles build: filling a tile of {} points", parameters.points_per_tile),
               construction_memory(parameters, device), device);
}

void build_tiles(const TilesBuildOptions& options)
{
    const PoissonTileParameters parameters = checked_parameters(options);
    check_target(options.out);
    Progress progress(Progress::detect(options.quiet));
    const auto begin = std::chrono::steady_clock::now();
    ConstructionOptions construction;
    construction.progress = [&](const std::string& stage, std::size_t done, std::size_t total) {
        stop_if_interrupted();
        progress.step(fmt::format("{}: {} of {}", stage, done, total));
    };
    std::optional<Device> device;
    const DeviceProvider open = [&]() -> Device& {
        if (!device) device = Device::open(options.device);
        return *device;
    };
    const Engine engine = *engines.find(options.engine);
    if (engine == Engine::opencl) check_memory(parameters, open().info());
    const ConstructedTileSet built = build_tile_set(parameters, engine, open, construction);
    write_tile_set(options.out, built.set);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    progress.finish();
    if (options.quiet) return;
    fmt::print("{}: {} tiles of {} points, every tiling has a relative radius of {:.4f} or more, {}\n",
               options.out.string(), parameters.tiles, parameters.points_per_tile,
               relative_radius_of(built.set.squared_min_distance, parameters), duration_text(seconds));
    if (built.report.failures > 0)
        fmt::print("{} of {} fillings did not reach the minimum distance and were repeated; {} pieces were "
                   "made again\n",
                   built.report.failures, built.report.tori, built.report.remade);
}

}

Command tiles_build_command()
{
    const auto o = std::make_shared<TilesBuildOptions>();
    return {
        "build",
        "Build a tile set and prove the minimum distance of its tilings",
        {{"KIND", &o->kind, "corner, edge, template or sphere"},
         as_parameter({"--colors", &o->colors, "Number of colours; not for template tiles", "C"}, "colors"),
         as_parameter({"--tiles", &o->tiles, "Number of template tiles", "T"}, "tiles"),
         as_parameter({"--points", &o->points, "Points of each tile", "N", required}, "points_per_tile"),
         {"--relative-radius", &o->relative_radius, option_help(parameter_of(sampler, "relative_radius")), "RHO"},
         {"--filling", &o->filling, option_help(parameter_of(sampler, "filling")), "NAME"},
         as_parameter({"--lloyd", &o->lloyd_iterations, option_help(parameter_of(sampler, "lloyd_iterations")), "I"},
                      "lloyd_iterations"),
         {"--repulsion", &o->repulsion, "Push apart what Lloyd relaxation leaves too close"},
         {"--border", &o->border, option_help(parameter_of(sampler, "border")), "NAME"},
         as_parameter(
             {"--joint-iterations", &o->joint_iterations, option_help(parameter_of(sampler, "joint_iterations")), "I"},
             "joint_iterations"),
         {"--null-peaks", &o->null_peaks, option_help(parameter_of(sampler, "null_peaks")), "on|off"},
         as_parameter({"--equal-moments", &o->equal_moments, option_help(parameter_of(sampler, "equal_moments")), "M"},
                      "equal_moments"),
         {"--ranked", &o->ranked, "Order points, so that any part of them is spread evenly: see tiles points"},
         {"--seed", &o->seed, "Everything random follows from it; default: 1", "S"},
         {"--out", &o->out, "The file: .ptiles, or .json for people", "FILE", required},
         {"--engine", &o->engine, "opencl (the default), or reference", "NAME"},
         {"--device", &o->device, "The OpenCL device: part of its name, or its number", "NAME"},
         {"--quiet", &o->quiet, "Print nothing but errors"}},
        tiles_build_notes,
        action_on(o, build_tiles)};
}

}
