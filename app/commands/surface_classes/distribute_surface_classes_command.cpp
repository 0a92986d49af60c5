// poissonlab distribute surface-classes: points of several classes on the triangles of a mesh.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "base/images/png_file.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/surface_classes/surface_class_set.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto surface_classes_notes =
    R"help(MESH is a file of polygons: .obj, .ply, .off, .stl, .gltf or .glb. Classes are those of distribute classes: points of each
class and all points together are even (Wei 2010), distances of pairs follow from those of classes, or are --matrix, row
after row. They are straight through space, in units of the mesh, and count between points whose normals are at most
--normal-angle apart.
  --distances D D ...             darts until no further one of any class fits, which is proven
  --points N N ... --distances D D ...
                                  so many of each class at these distances, or --relative-radius instead of --distances
  --points N N ... --factor F     all distances are multiplied by F wherever a class has no room for its next point
  --densities, once for each class, with --points
                                  what classes follow: a formula in x, y and z, a number of the mesh's vertices such as
                                  red, or a picture over its texture coordinates
Classes are counted from 0, in the order in which they are given. --out, as often as you like: .ply (binary) and .csv, both
with normals nx, ny, nz and the class, .glb (glTF 2.0: for each class a node with points and normals), and .png (two views
with z up, from the front on the left and from behind on the right, --pixels wide together, a colour for each class).
With --faces, .ply and .csv have the face, barycentric coordinates and numbers of the mesh's vertices as well.
With --instances, once for all or once for each class, .glb repeats these models, files of meshes or cone, at the points
of each class, their y axes along the normals (EXT_mesh_gpu_instancing).
  poissonlab distribute surface-classes bunny.ply --points 100 400 1600 --out plants.ply --out plants.png
  poissonlab distribute surface-classes part.obj --distances 0.5 0.2 --faces --out full.csv --json
  poissonlab distribute surface-classes bunny.ply --points 50 800 --densities y --densities "exp(-y/40)" --out plants.glb
  poissonlab distribute surface-classes hill.ply --points 40 900 --instances tree.glb --instances bush.obj --out wood.glb)help";

void write_classes_output(const std::filesystem::path& file, const SurfaceClassSet& set,
                          const SurfaceClassSettings& settings, const KindOptions& o, const std::string& what)
{
    const ClassSurfaceDarts& darts = set.darts;
    if (file.extension() == ".png")
        return write_png(file, surface_view(set.surface(), darts.points, dots_of(set), static_cast<int>(o.pixels)));
    if (file.extension() == ".glb" && settings.instances.are_given())
        return write_surface_instances(file, set.surface(), darts.points, darts.classes, settings.instances, o.seed());
    write_surface_points(file, set.surface(), darts.points, darts.classes, o.command_comment(what),
                         settings.faces ? &set.work.mesh->mesh : nullptr);
}

void place_classes_on_surface(const KindOptions& o)
{
    const auto settings = o.read<SurfaceClassSettings>();
    if (settings.faces && std::ranges::none_of(o.outs.files(), has_surface_columns))
        throw InputError("--faces: needs a .ply or .csv file as --out: other files have no such columns");
    check_instance_files(settings.instances, o.outs.files());
    for (const std::string& note : surface_class_mesh(settings)->notes()) o.say_note(note);
    const SurfaceClassSet set = throw_surface_classes(settings, o.seed(), o.place());
    std::string what = fmt::format(
        "{} {} of {} {}: {}", set.darts.points.size(), noun(set.darts.points.size(), "point"), set.darts.is_full.size(),
        noun(set.darts.is_full.size(), "class", "classes"), fmt::join(set.darts.counts(), ", "));
    if (settings.classes.points.empty()) what += "; no further one fits";
    if (set.darts.scale < 1) what += fmt::format("; distances multiplied by {:.6g}", set.darts.scale);
    o.say_note(what);
    for (const std::filesystem::path& out : o.outs.files()) write_classes_output(out, set, settings, o, what);
    if (o.prints_json()) print_numbers(surface_class_numbers(set, pairs_of(set)));
}

}

Command distribute_surface_classes_command()
{
    return kind_command(*find_kind("distribution", "surface-classes"), OutputFiles{{{".ply", ".csv", ".glb", ".png"}}},
                        surface_classes_notes, place_classes_on_surface, "mesh",
                        {16384, std::to_string(default_view_pixels), default_view_pixels});
}

}
