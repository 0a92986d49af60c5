// kind = "instances": tables for renderers, and a view from above.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.5, figures 7.5 and 7.6.
#include "base/files/whole_file.hpp"
#include "base/random/random.hpp"
#include "host/distribution/instances/instance_files.hpp"
#include "host/distribution/instances/instance_view.hpp"
#include "host/distribution/object_tiles.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

const std::vector<Interval> rectangle_ranges{{-1e6, 1e6}, {-1e6, 1e6}, {1e-3, 1e6}, {1e-3, 1e6}};
const std::vector<std::string> rectangle_parts{"x", "y", "width", "height"};

void terrain_keys(Keys& keys, InstanceSettings& s)
{
    keys.picture_or_formula("terrain", s.terrain,
                            "heights: the light of a picture, or a formula in x and y from -1 to 1");
    keys.numbers("terrain_area", s.terrain_area, rectangle_ranges, rectangle_parts,
                 "the rectangle that the terrain covers")
        .unit("units");
    keys.number("height", s.height, {-1e6, 1e6}, "how high 1 of the terrain is").unit("units");
    for (const char* key : {"terrain_area", "height"})
        if (keys.is_given(key) && s.terrain.empty()) throw keys.invalid(key, "needs " + keys.name_of("terrain"));
    if (s.terrain.empty()) return;
    if (s.scene == "asteroids") throw keys.invalid("terrain", "cannot be combined with asteroids");
    if (!keys.is_given("terrain_area"))
        throw keys.invalid("terrain",
                           fmt::format("needs {}, the rectangle that it covers", keys.name_of("terrain_area")));
    keys.check("terrain", [&] { values_of_text(s.terrain, "light", s.terrain_area[2], s.terrain_area[3]); });
}

void instance_keys(Keys& keys, InstanceSettings& s)
{
    keys.word("scene", s.scene, instance_scenes(), "what is placed");
    s = scene_settings(s.scene);
    keys.tiles(s.tiles).otherwise("corner tiles, for asteroids sphere tiles");
    keys.number("density", s.density, {1e-6, 1e6}, "instances in a unit square or cube, on average")
        .otherwise("2000, 500 or 40000 by scene");
    keys.numbers("window", s.window, rectangle_ranges, rectangle_parts, "where instances are wanted")
        .unit("units")
        .otherwise("one unit square, or a whole belt");
    keys.integer("models", s.models, 1, most_models, "how many models there are").otherwise("5, 11 or 8 by scene");
    keys.spread("scale", s.scale, {0.001, 1}, "how large instances are, of what fits their disks")
        .otherwise("uniform, from 0.7, 0.8 or 0.3 by scene to 1");
    keys.number("tilt", s.tilt, {0, most_tilt}, "the largest tilt")
        .unit("radians")
        .otherwise("0.06, 0.25 or 1.5 by scene");
    keys.numbers("ring", s.ring, {{-1e6, 1e6}, {1e-3, 1e6}}, {"inner", "outer", "thickness"},
                 "of asteroids: their belt")
        .unit("units")
        .otherwise("[0.55, 0.95, 0.08]");
    if (keys.is_given("ring") && s.scene != "asteroids") throw keys.invalid("ring", "is for asteroids");
    terrain_keys(keys, s);
    keys.integer("pixels", s.pixels, least_view_pixels, most_view_pixels, "the width of the view from above");
    if (!keys.is_read()) return;
    try {
        check_instances(s);
    } catch (const InputError& error) {
        throw keys.problem(error.what());
    }
}

std::string instance_label(const InstanceSettings& s) { return "Instances: " + s.scene; }

DistributionResult make_instances(const InstanceSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                  DistributionFiles& files)
{
    const ObjectTileSet tiles(object_tile_set(settings.tiles, instance_dimension(settings), place));
    const PoissonTiling tiling{stream_key(seed, Purpose::tile_choice, 0)[0], 0};
    const std::vector<Instance> instances = instances_in(tiles, tiling, settings, place);
    const double radius = instance_radius(tiles, settings);

    DistributionResult result;
    result.facts = {settings.scene, fmt::format("{} instances of {} models", instances.size(), settings.models),
                    fmt::format("{} x {} units", settings.window[2], settings.window[3])};
    if (!settings.terrain.empty()) result.facts.emplace_back("on a terrain, whose slopes stretch distances");
    write_png(files.add("above.png"), view_from_above(instances, settings, radius));
    result.pictures.push_back({"above.png", "From above: simple bodies that show model, turn, scale and tilt."});
    write_whole_file(files.add("instances.csv", result), instances_csv(instances));
    write_whole_file(files.add("instances.ply", result), instances_ply(instances));
    write_whole_file(files.add("instances.usda", result), instances_usda(instances, settings, radius));
    write_instances_glb(files.add("instances.glb", result), instances, settings, radius);
    result.numbers = instance_numbers(instances.size(), settings, radius);
    return result;
}

}

DistributionNumbers instance_numbers(std::size_t instances, const InstanceSettings& settings, double radius)
{
    return {
        {"instances", "Instances", static_cast<double>(instances), "in the window"},
        {"expected", "Expected", expected_instances(settings), "the density times what the scene fills of the window"},
        {"radius", "Radius", radius, "units: instances that are no larger than a disk of it do not overlap"}};
}

Kind instance_kind()
{
    return make_kind<InstanceSettings>({"distribution", "instances", "distribute instances", "Instances",
                                        "Place instances of models: a forest, sunflowers, asteroids"},
                                       instance_keys, instance_label, make_instances);
}

}
