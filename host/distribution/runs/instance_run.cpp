// kind = "instances": tables for renderers, and a view from above.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.5, figures 7.5 and 7.6.
#include "base/files/whole_file.hpp"
#include "base/random/random.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/instances/instance_files.hpp"
#include "host/distribution/instances/instance_view.hpp"
#include "host/distribution/object_tiles.hpp"

#include <fmt/format.h>

namespace poissonlab {

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
    const PngPixels view = view_from_above(instances, settings, radius);
    write_png(files.add("above.png"), {view.width, view.height, 3},
              [&](int first, int) { return &view.values[view.at(0, first, 0)]; });
    result.pictures.push_back({"above.png", "From above: simple bodies that show model, turn, scale and tilt."});
    write_whole_file(files.add("instances.csv"), instances_csv(instances));
    write_whole_file(files.add("instances.ply"), instances_ply(instances));
    write_whole_file(files.add("instances.usda"), instances_usda(instances, settings, radius));
    for (const char* name : {"instances.csv", "instances.ply", "instances.usda"}) result.files.emplace_back(name);
    result.numbers.push_back({"instances", "Instances", static_cast<double>(instances.size()), "in the window"});
    result.numbers.push_back(
        {"expected", "Expected", expected_instances(settings), "the density times what the scene fills of the window"});
    result.numbers.push_back(
        {"radius", "Radius", radius, "units: instances that are no larger than a disk of it do not overlap"});
    return result;
}

}
