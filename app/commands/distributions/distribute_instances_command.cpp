// poissonlab distribute instances: forests, sunflowers and asteroids, by window.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
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

constexpr auto distribute_instances_notes =
    R"help(What an instance is follows from the identity of its point in an endless tiling: position, model, turn about z,
scale, and a tilt from z into a direction, angles in radians. Windows in parts and at once therefore have the same
instances; tile and index tell them apart. No two are nearer than twice the radius of the disks, which the view from
above fills at scale 1.
SCENE is forest or sunflowers, in the plane, with --terrain on a height picture over --terrain-area (slopes stretch
distances, heights between pixels are linear), or asteroids: the points of a tiling of space between two cylinders,
--ring.
Of tiles whose points have classes (tiles build --class-points) each class has models of its own: the number of a model
modulo the number of classes is the class, which .csv and .ply have as well. With as many models, each class is one.
--out, as often as you like: .csv, .ply (vertices with properties), .usda (a point instancer) and .glb (glTF with
EXT_mesh_gpu_instancing, y upwards), both with stand-ins for your models, .png (a shaded view from above, --pixels
wide).
  poissonlab distribute instances forest --window 0 0 1 1 --out forest.csv --out forest.png
  poissonlab distribute instances forest --window 0 0 2 1 --terrain hills.png --terrain-area 0 0 2 1 --height 0.2 \
    --out forest.usda
  poissonlab distribute instances asteroids --ring 0.5 0.9 0.1 --out belt.ply --out belt.png)help";

void write_instances(const std::filesystem::path& file, const std::vector<Instance>& instances,
                     const InstanceSettings& settings, double radius)
{
    const std::string extension = file.extension();
    if (extension == ".csv") write_whole_file(file, instances_csv(instances));
    if (extension == ".ply") write_whole_file(file, instances_ply(instances));
    if (extension == ".usda") write_whole_file(file, instances_usda(instances, settings, radius));
    if (extension == ".glb") write_instances_glb(file, instances, settings, radius);
    if (extension == ".png") write_png(file, view_from_above(instances, settings, radius));
}

void place_instances(const KindOptions& o)
{
    const auto settings = o.read<InstanceSettings>();
    const DistributionPlace place = o.place();
    const ObjectTileSet tiles(object_tile_set(settings.tiles, instance_dimension(settings), place));
    const PoissonTiling tiling{stream_key(o.seed(), Purpose::tile_choice, 0)[0], 0};
    const std::vector<Instance> instances = instances_in(tiles, tiling, settings, place);
    const double radius = instance_radius(tiles, settings);
    for (const std::filesystem::path& out : o.outs.files()) write_instances(out, instances, settings, radius);
    if (o.prints_json())
        print_numbers(instance_numbers(instances.size(), settings, radius));
    else if (!o.is_quiet())
        fmt::print("{} instances of {} models; {:.1f} are expected; disks have a radius of {:.5f}\n", instances.size(),
                   settings.models, expected_instances(settings), radius);
}

}

Command distribute_instances_command()
{
    return kind_command(*find_kind("distribution", "instances"), {{{".csv", ".ply", ".usda", ".glb", ".png"}}},
                        distribute_instances_notes, place_instances, "scene");
}

}
