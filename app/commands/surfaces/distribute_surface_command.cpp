// poissonlab distribute surface: points on the triangles of a mesh.
#include "app/commands/kind_options.hpp"
#include "base/images/png_file.hpp"
#include "base/text/noun.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/distribution/surfaces/surface_view.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto distribute_surface_notes =
    R"help(MESH is a file of polygons: .obj, .ply, .off, .stl, .gltf or .glb. Points lie on its triangles, and distances are straight through
space, in units of the mesh. Distances count between points whose normals are at most --normal-angle apart: the two
sides of a thin sheet are each even by themselves, and points of different sides may be near.
  --min-distance D                       darts until no further one fits: all of the surface is nearer than D to a point
  --points N --min-distance D            darts until there are N, or --relative-radius instead of --min-distance
  --points N                             darts at a distance that shrinks until N fit
  --points N --method elimination        N of five times as many random points; each beginning of the file is even, too
  --points N --method elimination --density "1 + z^2"
                                         N that follow a density: a formula, a number of the mesh's vertices such as red,
                                         or a picture over its texture coordinates
  --points N --method lloyd              N darts that move to the centroids of their cells, --iterations times
  --start FILE, --obstacles FILE         the set begins with the points of the first file; others keep away from the second
  --tiles SET --tiles-per-unit T         the points of a tiling laid over texture coordinates (u, v) of the mesh, or
                                         --points N instead of T; with --min-distance D those are left out, in the order
                                         of ranks, that are nearer than D to others. What stretch and seams of the
                                         coordinates make of distances is measured.
  --method quads --points N              about N points of tiles on the quads of a closed surface, which fit everywhere:
                                         its own faces, or with --quads cube or polycube squares that it is mapped to
Relative radii are those of a plane of the same area. Distances are checked in whole numbers after the fact.
--out, as often as you like: .ply (binary) and .csv, both with normals nx, ny, nz, .glb (glTF 2.0: points with normals),
.png (two views with z up, from the front on the left and from behind on the right, --pixels wide together), and point files
such as .npy and text.
With --faces, .ply and .csv have further columns: face (from 0, in the order of the file), vertex_0 to vertex_2, the
barycentric coordinates bary_0 to bary_2, and the numbers of the vertices, interpolated: shading_nx, shading_ny,
shading_nz, u, v, red, green, blue and all others.
With --instances FILE or --instances cone, .glb repeats that model at each point, its y axis along the normal
(EXT_mesh_gpu_instancing).
  poissonlab distribute surface bunny.ply --points 10000 --out points.ply --out points.png
  poissonlab distribute surface scan.ply --points 10000 --faces --out points.csv
  poissonlab distribute surface part.obj --min-distance 0.5 --out points.csv --json
  poissonlab distribute surface bunny.ply --points 3000 --instances tuft.obj --out grass.glb
  poissonlab distribute surface scene.glb --tiles corner.ptiles --points 50000 --json --out points.ply)help";

void write_surface_output(const std::filesystem::path& file, const SurfaceSet& set, const MeshPointSettings& settings,
                          const KindOptions& o, const std::string& what)
{
    const FixedSurface& surface = set.mesh->surface;
    if (file.extension() == ".png")
        return write_png(file, surface_view(surface, set.points, dots_of(set), static_cast<int>(o.pixels)));
    if (file.extension() == ".glb" && settings.instances.are_given())
        return write_surface_instances(file, surface, set.points, {}, settings.instances, o.seed());
    write_surface_points(file, surface, set.points, o.command_comment(what),
                         settings.faces ? &set.mesh->mesh : nullptr);
}

void place_on_surface(const KindOptions& o)
{
    const auto settings = o.read<MeshPointSettings>();
    if (settings.faces && std::ranges::none_of(o.outs.files(), has_surface_columns))
        throw InputError("--faces: needs a .ply or .csv file as --out: other files have no such columns");
    check_instance_files(settings.instances, o.outs.files());
    for (const std::string& note : surface_mesh(settings)->notes()) o.say_note(note);
    const SurfaceSet set = make_surface_set(settings, o.seed(), o.place());
    for (const std::string& note : set.notes) o.say_note(note);
    std::string what =
        fmt::format("{} {}, {}", set.points.size(), noun(set.points.size(), "point"), surface_fact(set, settings));
    if (set.min_distance > 0)
        what += fmt::format(
            "; at least {} apart{}", set.min_distance,
            set.angle < 180 ? fmt::format(" where their normals differ by {:.4g} degrees at most", set.angle) : "");
    o.say_note(what);
    for (const std::filesystem::path& out : o.outs.files()) write_surface_output(out, set, settings, o, what);
    if (o.prints_json()) print_numbers(surface_numbers(set, o.seed()));
}

}

Command distribute_surface_command()
{
    return kind_command(*find_kind("distribution", "surface"), {{{".png", ".glb"}, true}}, distribute_surface_notes,
                        place_on_surface, "mesh", {16384, std::to_string(default_view_pixels), default_view_pixels});
}

}
