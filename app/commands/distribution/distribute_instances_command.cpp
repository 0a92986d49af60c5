// poissonlab distribute instances: forests, sunflowers and asteroids, by window.
#include "app/commands/distribution/distribute_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/random/random.hpp"
#include "host/config/distributions/instance_table.hpp"
#include "host/distribution/instances/instance_files.hpp"
#include "host/distribution/instances/instance_view.hpp"
#include "host/distribution/object_tiles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr auto distribute_instances_notes =
    R"help(What an instance is follows from the identity of its point in an endless tiling: position, model, turn about z,
scale, and a tilt from z into a direction, angles in radians. Windows in parts and at once therefore have the same
instances; tile and index tell them apart. No two are nearer than twice the radius of the disks, which the view from
above fills at scale 1.
SCENE is forest or sunflowers, in the plane, with --terrain on a height picture over --terrain-area (slopes stretch
distances, heights between pixels are linear), or asteroids: the points of a tiling of space between two cylinders,
--ring.
--out, as often as you like: .csv, .ply (vertices with properties), .usda (a point instancer with stand-ins for your
models), .png (a shaded view from above, --pixels wide).
  poissonlab distribute instances forest --window 0 0 1 1 --out forest.csv --out forest.png
  poissonlab distribute instances forest --window 0 0 2 1 --terrain hills.png --terrain-area 0 0 2 1 --height 0.2 \
    --out forest.usda
  poissonlab distribute instances asteroids --ring 0.5 0.9 0.1 --out belt.ply --out belt.png)help";

constexpr std::uint32_t models_not_given = UINT32_MAX;

struct InstanceOptions : DistributeOptions
{
    std::string scene;
    double instances = NAN;
    std::string terrain;
    std::vector<double> window, scale, ring, terrain_area;
    std::uint32_t models = models_not_given;
    double tilt = NAN;
    double height = NAN;
    std::vector<std::string> outs;
    std::uint32_t pixels = 1024;
};

InputError bad_option(const InstanceOptions& o, const std::string& option, const std::string& text,
                      const std::string& allowed)
{
    return InputError(fmt::format("{}: {} {}: must be {}", o.command, option, printable(text), allowed));
}

/// The numbers of an option that takes so many.
template <std::size_t count>
std::array<double, count> numbers_of(const InstanceOptions& o, const std::string& option,
                                     const std::vector<double>& given, const std::string& allowed)
{
    if (given.size() != count) throw bad_option(o, option, fmt::format("{}", fmt::join(given, " ")), allowed);
    std::array<double, count> numbers{};
    std::ranges::copy(given, numbers.begin());
    return numbers;
}

double checked(const InstanceOptions& o, const std::string& option, double value, double low, double high)
{
    if (!(value >= low && value <= high))
        throw bad_option(o, option, fmt::format("{}", value), fmt::format("from {} to {}", low, high));
    return value;
}

constexpr double farthest_units = 1e6;

std::array<double, 4> rectangle(const InstanceOptions& o, const std::string& option, const std::vector<double>& given)
{
    const std::string allowed = "X Y W H with sizes above 0 and at most 1e6";
    const auto numbers = numbers_of<4>(o, option, given, allowed);
    const bool is_far = std::ranges::any_of(numbers, [](double number) { return std::abs(number) > farthest_units; });
    if (is_far || !(numbers[2] > 0 && numbers[3] > 0))
        throw bad_option(o, option, fmt::format("{}", fmt::join(given, " ")), allowed);
    return numbers;
}

/// The further rules of a ring are those of check_instances().
std::array<double, 3> ring_of(const InstanceOptions& o)
{
    const std::string allowed = "INNER OUTER THICKNESS, each at most 1e6";
    const auto numbers = numbers_of<3>(o, "--ring", o.ring, allowed);
    if (std::ranges::max(numbers) > farthest_units)
        throw bad_option(o, "--ring", fmt::format("{}", fmt::join(o.ring, " ")), allowed);
    return numbers;
}

std::array<double, 2> scales(const InstanceOptions& o)
{
    const std::string allowed = "LOW HIGH with 0.001 <= LOW <= HIGH <= 1";
    const auto numbers = numbers_of<2>(o, "--scale", o.scale, allowed);
    if (!(numbers[0] >= 0.001 && numbers[0] <= numbers[1] && numbers[1] <= 1))
        throw bad_option(o, "--scale", fmt::format("{}", fmt::join(o.scale, " ")), allowed);
    return numbers;
}

void set_terrain(const InstanceOptions& o, InstanceSettings& settings)
{
    if (o.terrain.empty() != o.terrain_area.empty())
        throw InputError(o.command + ": --terrain and --terrain-area go together");
    if (!o.terrain.empty() && settings.scene == "asteroids")
        throw InputError(o.command + ": --terrain: does not go with asteroids");
    if (o.terrain.empty() && !std::isnan(o.height)) throw InputError(o.command + ": --height: goes with --terrain");
    if (o.terrain.empty()) return;
    settings.terrain = o.terrain;
    settings.terrain_area = rectangle(o, "--terrain-area", o.terrain_area);
    if (!std::isnan(o.height)) settings.height = checked(o, "--height", o.height, -farthest_units, farthest_units);
}

InstanceSettings checked_instances(const InstanceOptions& o)
{
    check_engine(o);
    const auto& scenes = instance_scenes();
    if (std::ranges::find(scenes, o.scene) == scenes.end())
        throw InputError(
            fmt::format("{}: {}: must be one of {}", o.command, printable(o.scene), fmt::join(scenes, ", ")));
    InstanceSettings settings = scene_settings(o.scene);
    settings.tiles = o.tiles;
    if (!std::isnan(o.instances)) settings.density = checked(o, "--density", o.instances, 1e-6, 1e6);
    if (!o.window.empty()) settings.window = rectangle(o, "--window", o.window);
    if (o.models != models_not_given)
        settings.models = static_cast<std::uint32_t>(checked(o, "--models", o.models, 1, most_models));
    if (!o.scale.empty()) {
        const auto [low, high] = scales(o);
        settings.scale = {SpreadChoice::Kind::uniform, low, high};
    }
    if (!std::isnan(o.tilt)) settings.tilt = checked(o, "--tilt", o.tilt, 0, 1.5);
    if (!o.ring.empty() && o.scene != "asteroids") throw InputError(o.command + ": --ring: is for asteroids");
    if (!o.ring.empty()) settings.ring = ring_of(o);
    set_terrain(o, settings);
    settings.pixels = static_cast<std::uint32_t>(checked(o, "--pixels", o.pixels, least_view_pixels, most_view_pixels));
    for (const std::string& out : o.outs) {
        const std::string extension = std::filesystem::path(out).extension();
        if (extension != ".csv" && extension != ".ply" && extension != ".usda" && extension != ".png")
            throw bad_option(o, "--out", out, "a file that ends in .csv, .ply, .usda or .png");
        check_output(o, out);
    }
    return settings;
}

void write_instances(const std::filesystem::path& file, const std::vector<Instance>& instances,
                     const InstanceSettings& settings, double radius)
{
    const std::string extension = file.extension();
    if (extension == ".csv") write_whole_file(file, instances_csv(instances));
    if (extension == ".ply") write_whole_file(file, instances_ply(instances));
    if (extension == ".usda") write_whole_file(file, instances_usda(instances, settings, radius));
    if (extension != ".png") return;
    const PngPixels view = view_from_above(instances, settings, radius);
    write_png(file, {view.width, view.height, 3}, [&](int first, int) { return &view.values[view.at(0, first, 0)]; });
}

void place_instances(const InstanceOptions& o)
{
    const InstanceSettings settings = checked_instances(o);
    try {
        check_instances(settings);
        const DistributionPlace place = make_place(o);
        const ObjectTileSet tiles(object_tile_set(settings.tiles, instance_dimension(settings), place));
        const PoissonTiling tiling{stream_key(o.seed, Purpose::tile_choice, 0)[0], 0};
        const std::vector<Instance> instances = instances_in(tiles, tiling, settings, place);
        const double radius = instance_radius(tiles, settings);
        for (const std::string& out : o.outs) write_instances(out, instances, settings, radius);
        if (!o.quiet)
            fmt::print("{} instances of {} models; {:.1f} are expected; disks have a radius of {:.5f}\n",
                       instances.size(), settings.models, expected_instances(settings), radius);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", o.command, error.what()));
    }
}

}

Command distribute_instances_command()
{
    const auto o = std::make_shared<InstanceOptions>();
    o->command = "distribute instances";
    const std::vector<Option> own{
        {"SCENE", &o->scene, "forest, sunflowers or asteroids", "SCENE", required},
        {"--window", &o->window, "Where instances are wanted, in units; default: one unit square, a whole belt",
         "X Y W H", optional, 4},
        {"--density", &o->instances, "Instances in a unit square (cube), on average; default: 2000, 500, 40000", "N"},
        allowing({"--models", &o->models, "How many models there are; default: 5, 11, 8", "M"},
                 integers(1, most_models)),
        {"--scale", &o->scale, "Scales are uniform between these", "LOW HIGH", optional, 2},
        {"--tilt", &o->tilt, "The largest tilt", "RADIANS"},
        {"--ring", &o->ring, "Of asteroids; default: 0.55 0.95 0.08", "INNER OUTER THICKNESS", optional, 3},
        {"--terrain", &o->terrain, "Heights: the light of a picture, or a formula in x and y from -1 to 1",
         "IMAGE|FORMULA"},
        {"--terrain-area", &o->terrain_area, "The rectangle that it covers", "X Y W H", optional, 4},
        {"--height", &o->height, "Units that 1 of the terrain is high; default: 1", "H"},
        {"--seed", &o->seed, "Which tiling; default: 1", "S"},
        {"--tiles", &o->tiles, "A tile set, for asteroids in space; default: corner or sphere tiles", "FILE"},
        {"--out", &o->outs, "A file, .csv, .ply, .usda or .png; may be repeated", "FILE", required},
        allowing({"--pixels", &o->pixels, "The width of a .png; default: 1024", "W"},
                 integers(least_view_pixels, most_view_pixels))};
    return {"instances", "Place instances of models: a forest, sunflowers, asteroids",
            joined({own, device_options(*o)}), distribute_instances_notes, action_on(o, place_instances)};
}

}
