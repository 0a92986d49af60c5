// poissonlab texture surface and distribute objects cover the quads of a mesh with textures and with objects.
#include "app/commands/kind_options.hpp"
#include "host/distribution/surface_textures/surface_texture.hpp"
#include "host/kinds/kinds.hpp"

namespace poissonlab {
namespace {

constexpr auto texture_surface_notes =
    R"help(MESH is a closed surface of quads; --quads cube or polycube makes quads of other meshes. Each quad shows a tile, with the
texture that its neighbours continue across all edges and around all vertices, also where 3 or 5 quads meet. Pieces of the
exemplar are turned by quarters: it should look alike from all sides.
--out, as often as you like: .png (from the front and from behind, --pixels wide; z is up) and .glb (binary glTF with the
tiles as its texture, which any viewer shows).
  poissonlab texture surface cube.obj --smooth 1 --refine 6 --exemplar gravel.png --out cube.png --out cube.glb
  poissonlab texture surface head.obj --quads cube --refine 12 --exemplar cork.png --tiles corner --colors 4 --out head.glb)help";

constexpr auto surface_objects_notes =
    R"help(MESH is a closed surface of quads; --quads cube or polycube makes quads of other meshes. Objects lie at the points of a
Poisson disk tiling on the quads, in disks that do not overlap; with --dimension 3 at those of Poisson sphere tiles in
space, and the surface shows where it cuts them.
--out, as often as you like: .png (from the front and from behind, --pixels wide; z is up) and .glb (binary glTF).
  poissonlab distribute objects torus.obj --object stars --points 500 --out stars.png --out stars.glb)help";

void write_outputs(const KindOptions& o, const DressedSurface& dressed)
{
    for (const std::string& fact : dressed.facts) o.say_note(fact);
    for (const std::filesystem::path& out : o.outs.files()) write_dressed(out, dressed, static_cast<int>(o.pixels));
    if (o.prints_json()) print_numbers(dressed.numbers);
}

void dress_in_texture(const KindOptions& o)
{
    write_outputs(o, textured_surface(o.read<SurfaceTextureSettings>(), o.seed(), o.place()));
}

void dress_in_objects(const KindOptions& o)
{
    write_outputs(o, surface_of_objects(o.read<SurfaceObjectSettings>(), o.seed(), o.place()));
}

Command dressing_command(const char* word, const char* notes, void (*work)(const KindOptions&))
{
    return kind_command(*find_kind("distribution", word), {{{".png", ".glb"}}}, notes, work, "mesh",
                        {16384, std::to_string(default_quad_picture_pixels), default_quad_picture_pixels});
}

}

Command texture_surface_command()
{
    return dressing_command("textured-surface", texture_surface_notes, dress_in_texture);
}

Command distribute_objects_command()
{
    return dressing_command("surface-objects", surface_objects_notes, dress_in_objects);
}

}
