// kind = "textured-surface" and kind = "surface-objects" cover the quads of a mesh with textures and with objects.
#include "host/distribution/object_shapes.hpp"
#include "host/distribution/surface_textures/surface_texture.hpp"
#include "host/distribution/surfaces/quad_surface.hpp"
#include "host/distribution/surfaces/tiled_surface.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

void mesh_keys(Keys& keys, QuadSettings& s)
{
    keys.file("mesh", s.mesh, "the surface: a file of polygons, .obj, .ply, .off, .stl, .gltf or .glb", "a mesh")
        .required();
    quad_keys(keys, s, true, "");
    if (keys.is_read()) keys.check("mesh", [&] { s.read = quad_surface(s); });
}

void texture_keys(Keys& keys, SurfaceTextureSettings& s)
{
    mesh_keys(keys, s.quads);
    keys.picture("exemplar", s.exemplar, "the picture, of any kind that OpenImageIO reads; it is turned by quarters")
        .required();
    keys.picture("normals", s.normals, "a normal map of the exemplar's size, y upwards");
    keys.picture("heights", s.heights, "a map of heights of the exemplar's size, from which normals are made")
        .excludes("normals");
    keys.number("relief", s.relief, {0, 1000}, "how high the full range of heights is")
        .unit("pixels")
        .only_if(!s.heights.empty(), "heights");
    keys.word("tiles", s.labels, quad_label_words, "generalised Wang tiles, or corner tiles");
    keys.integer("colors", s.colors, 1, 5, "the number of colours of edges, at most 3; with corner tiles, of vertices");
    if (keys.is_given("colors") && s.labels == QuadLabels::wang && s.colors > 3)
        throw keys.invalid("colors", "must be at most 3 with Wang tiles");
    keys.integer("size", s.size, 16, 512, "the side of a tile").unit("pixels");
    keys.integer("candidates", s.candidates, 1, most_texture_candidates, "windows that are cut for a piece");
    if (keys.is_given("size") && s.size % 2 != 0) throw keys.invalid("size", "must be even");
}

void object_keys(Keys& keys, SurfaceObjectSettings& s)
{
    mesh_keys(keys, s.quads);
    keys.integer("dimension", s.dimension, 2, 3, "objects on the surface, or in a solid that it is cut out of");
    keys.tiles(s.tiles).otherwise("sphere tiles of 2 colours, 128 points").only_if(s.dimension == 3, "dimension = 3");
    keys.integer("points", s.points, 1, 1 << 22,
                 "the number of objects on the surface, about; of a solid in the cube as wide as the mesh");
    keys.word("object", s.object, object_looks(s.dimension), "the look of objects");
    keys.integer("texels", s.texels, 2, 256, "the pixels along a side of a quad in the atlas");
    keys.spread("size", s.size, {0, 1}, "the size of objects, in parts of their disks");
    keys.spread("orientation", s.orientation, {-1e4, 1e4}, "how objects are turned").unit("radians");
    keys.spread("aspect", s.aspect, {0.01, 100}, "how much wider than high objects are");
    if (!keys.is_read()) return;
    if (s.dimension == 2) keys.check("points", [&] { check_quad_points(s.points, s.quads.read->mesh.quads.size()); });
    if (const std::size_t wide = static_cast<std::size_t>(s.texels) + 4;
        s.quads.read->mesh.quads.size() * wide * wide > std::size_t{1} << 26)
        throw keys.problem(fmt::format("{} quads of {} x {} pixels are more than 2^26: fewer {} help",
                                       s.quads.read->mesh.quads.size(), s.texels, s.texels, keys.name_of("texels")));
}

std::string texture_label(const SurfaceTextureSettings& s)
{
    return fmt::format("{} on {}", name_of_input(s.exemplar.string()), name_of_input(s.quads.mesh.string()));
}

std::string object_label(const SurfaceObjectSettings& s)
{
    return fmt::format("{} on {}", s.object, name_of_input(s.quads.mesh.string()));
}

DistributionResult result_of(const DressedSurface& dressed, DistributionFiles& files)
{
    DistributionResult result;
    result.facts = dressed.facts;
    result.numbers = dressed.numbers;
    write_dressed(files.add("surface.png"), dressed, default_quad_picture_pixels);
    result.pictures.push_back(
        {"surface.png", "The surface in the sun: left from the front above, right from behind above."});
    write_png(files.add("atlas.png"), dressed.atlas.color);
    result.pictures.push_back({"atlas.png", "The pictures that its quads show, with gutters."});
    write_dressed(files.add("surface.glb", result), dressed, 0);
    return result;
}

DistributionResult make_texture_result(const SurfaceTextureSettings& settings, std::uint64_t seed,
                                       const DistributionPlace& place, DistributionFiles& files)
{
    return result_of(textured_surface(settings, seed, place), files);
}

DistributionResult make_object_result(const SurfaceObjectSettings& settings, std::uint64_t seed,
                                      const DistributionPlace& place, DistributionFiles& files)
{
    return result_of(surface_of_objects(settings, seed, place), files);
}

}

Kind textured_surface_kind()
{
    return make_kind<SurfaceTextureSettings>({"distribution", "textured-surface", "texture surface",
                                              "Texture on a surface",
                                              "Lay texture tiles on the quads of a mesh, of any genus", false},
                                             texture_keys, texture_label, make_texture_result);
}

Kind surface_object_kind()
{
    return make_kind<SurfaceObjectSettings>(
        {"distribution", "surface-objects", "distribute objects", "Objects on a surface",
         "Evaluate the procedural object distribution function on the quads of a mesh", false},
        object_keys, object_label, make_object_result);
}

}
