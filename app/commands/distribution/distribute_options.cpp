#include "app/commands/distribution/distribute_options.hpp"

#include "app/commands/point_target.hpp"
#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/config/sampler_table.hpp"
#include "host/config/toml_reader.hpp"
#include "host/run/progress.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr std::uint64_t most_points = std::uint64_t{1} << 27;

/// The method that a text says: a sampler's name, or a table as in a config.
SamplerChoice method_of(const DistributeOptions& o)
{
    const std::string option = o.command + ": --method";
    const bool is_table = o.method.find('{') != std::string::npos;
    const ConfigTable top = read_toml("method = " + (is_table ? o.method : '"' + o.method + '"'), option);
    static const ParameterSpec spec{.key = "method", .kind = ParameterSpec::Kind::sampler};
    const auto choices = sampler_choices(spec, *find(top, "method"), sampler_registry(), 0);
    if (choices.size() != 1) throw InputError(option + ": has lists: must be one method");
    return *as_sampler(choices.front().value);
}

}

std::vector<Option> density_options(DistributeOptions& o)
{
    return {
        {"--density", &o.density, "What points follow: a picture, or a formula in x and y from -1 to 1",
         "IMAGE|FORMULA", required},
        {"--density-from", &o.density_from, "Of a picture: light (the default), ink, or one of its channels", "NAME"}};
}

Option points_option(DistributeOptions& o, const std::string& help)
{
    return allowing({"--points", &o.points, help, "N", required}, integers(1, most_points));
}

std::vector<Option> even_point_options(DistributeOptions& o)
{
    return {
        points_option(o, "How many points: tilings have exactly so many, other methods about"),
        {"--seed", &o.seed, "Which points; default: 1", "S"},
        {"--tiles", &o.tiles, "The tile set of the even points; default: corner tiles of 3 colours, 32 points", "FILE"},
        {"--method", &o.method, "Another method of even points: a sampler's name, or { sampler = ..., ... }",
         "NAME|TABLE", optional, 1, "--tiles"}};
}

std::vector<Option> device_options(DistributeOptions& o)
{
    return {{"--engine", &o.engine, "opencl (the default) or reference", "NAME"},
            {"--device", &o.device, "The OpenCL device: part of its name, or its number", "NAME"},
            {"--quiet", &o.quiet, "Do not show steps"}};
}

std::vector<Option> output_options(DistributeOptions& o)
{
    return joined({{{"--out", &o.out, "The point file", "FILE", required}}, device_options(o)});
}

std::vector<Option> joined(std::vector<std::vector<Option>> lists)
{
    std::vector<Option> all;
    for (auto& list : lists) std::ranges::move(list, std::back_inserter(all));
    return all;
}

void check_engine(const DistributeOptions& o)
{
    if (!engines.find(o.engine))
        throw InputError(fmt::format("{}: --engine \"{}\": must be one of {}", o.command, printable(o.engine),
                                     fmt::join(engines.all(), ", ")));
}

void check_output(const DistributeOptions& o, const std::filesystem::path& file)
{
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code unknown;
    if (!std::filesystem::is_directory(folder, unknown))
        throw InputError(fmt::format("{}: --out {}: there is no folder {}", o.command, file.string(), folder.string()));
    if (std::filesystem::is_directory(file, unknown))
        throw InputError(fmt::format("{}: --out {}: is a folder", o.command, file.string()));
}

void check_points(const DistributeOptions& o)
{
    if (o.points < 1 || o.points > most_points)
        throw InputError(fmt::format("{}: --points {}: must be from 1 to {}", o.command, o.points, most_points));
}

void check(const DistributeOptions& o)
{
    check_engine(o);
    check_points(o);
    check_output(o, o.out);
    check_point_target(o.command, o.out);
}

void say_note(const DistributeOptions& o, const std::string& note)
{
    if (!note.empty() && !o.quiet) fmt::print(stderr, "poissonlab: note: {}\n", note);
}

Density read_density(const DistributeOptions& o)
{
    try {
        Density density = density_of_text(o.density, o.density_from, 1, 1);
        say_note(o, density.note);
        return density;
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: --density {}", o.command, error.what()));
    }
}

EvenMethod read_even_method(const DistributeOptions& o)
{
    if (!o.method.empty()) return method_of(o);
    if (o.tiles.empty()) return default_even_method();
    PoissonTileSet tiles = read_tile_set(o.tiles);
    if (tiles.parameters.dimension != 2)
        throw InputError(
            fmt::format("{}: --tiles {}: are tiles in space; must be in the plane", o.command, o.tiles.string()));
    return tiles;
}

EvenMethodChoice even_method_choice(const DistributeOptions& o)
{
    EvenMethodChoice choice{o.tiles, {}};
    if (!o.method.empty()) choice.sampler = method_of(o);
    return choice;
}

DistributionPlace make_place(const DistributeOptions& o)
{
    const auto device = std::make_shared<std::optional<Device>>();
    const auto progress = std::make_shared<Progress>(Progress::detect(o.quiet));
    return {*engines.find(o.engine),
            [device, name = o.device]() -> Device& {
                if (!*device) *device = Device::open(name);
                return **device;
            },
            [progress](const std::string& what) {
                stop_if_interrupted();
                progress->step(what);
            }};
}

}
