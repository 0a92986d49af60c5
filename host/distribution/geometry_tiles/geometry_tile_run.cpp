// kind = "geometry-tiles": a field of plants in perspective by layered depth images of tiles, beside the whole scene.
//
// Cohen, Shade, Hiller, Deussen, Wang tiles for image and texture generation, 2003, section 4, figures 12 and 13.
#include "host/distribution/geometry_tiles/geometry_tile_run.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/cache_folder.hpp"
#include "base/random/random.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "host/distribution/geometry_tiles/picture_difference.hpp"
#include "host/distribution/geometry_tiles/plant_field.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>

namespace poissonlab {
namespace {

/// Tiles are made of one of these kinds.
enum class PlantTileKind
{
    corner,
    template_tiles
};
constexpr WordTable<PlantTileKind, 2> plant_tile_kinds{
    {{{PlantTileKind::corner, "corner"}, {PlantTileKind::template_tiles, "template"}}}};

/// A mesh has at most so many vertices, which each plant of a tile needs some 40 bytes for, and is at most so high, in
/// halves of its width.
constexpr std::size_t most_mesh_vertices = 20'000;
constexpr int most_mesh_height = 40;

struct GeometryTileSettings
{
    std::filesystem::path tiles; ///< empty: made of what follows
    PlantTileKind tile_kind = PlantTileKind::corner;
    std::uint32_t colors = 2; ///< of corners
    std::uint32_t tile_count = 8;
    std::uint32_t plants = 20;               ///< in a tile
    std::filesystem::path mesh;              ///< empty: sunflowers
    std::shared_ptr<const PlantModel> model; ///< what it was read as
    std::uint32_t models = 11;
    double facing = -90, spread = 40; ///< degrees
    std::string terrain;              ///< empty: flat
    double height = 1;                ///< tiles
    FieldSettings view;
};

PoissonTileParameters tile_parameters(const GeometryTileSettings& s)
{
    PoissonTileParameters p;
    p.kind = s.tile_kind == PlantTileKind::corner ? PoissonTileKind::corner : PoissonTileKind::frame;
    p.colors = s.tile_kind == PlantTileKind::corner ? s.colors : 1;
    p.tiles = s.tile_kind == PlantTileKind::corner ? tile_count(p.kind, 2, p.colors) : s.tile_count;
    p.points_per_tile = s.plants;
    p.relative_radius = 0.7;
    p.lloyd_iterations = 20;
    return p;
}

void tile_keys(Keys& keys, GeometryTileSettings& s)
{
    keys.tiles(s.tiles).otherwise("made of the keys that follow");
    keys.word("tile_kind", s.tile_kind, plant_tile_kinds, "corner tiles, or template tiles, which have one border");
    keys.integer("colors", s.colors, 1, 3, "the number of colours of corners")
        .only_if(s.tile_kind == PlantTileKind::corner, "tile_kind = corner");
    keys.integer("tile_count", s.tile_count, 1, 64, "the number of template tiles")
        .only_if(s.tile_kind == PlantTileKind::template_tiles, "tile_kind = template");
    keys.integer("plants", s.plants, 8, 512, "the number of plants in a tile");
    for (const char* key : {"tile_kind", "colors", "tile_count", "plants"})
        if (keys.is_given(key) && !s.tiles.empty())
            throw keys.invalid(key, "cannot be combined with " + keys.name_of("tiles"));
    if (!keys.is_read()) return;
    if (s.tiles.empty())
        keys.check([&] { check(tile_parameters(s)); });
    else
        keys.check("tiles", [&] { plant_radius(read_tile_set(s.tiles)); });
}

void camera_keys(Keys& keys, FieldSettings& v)
{
    keys.numbers("eye", v.eye, {{-1000, 2000}, {-1000, 2000}, {0.5, 1000}}, {"x", "y", "height"},
                 "the camera: its place, and its height above the ground there")
        .unit("tiles");
    keys.number("heading", v.heading, {-360, 360}, "the direction in which it looks, from x towards y").unit("degrees");
    keys.number("pitch", v.pitch, {-89, 89}, "how far down from the horizon it looks").unit("degrees");
    keys.number("angle_of_view", v.angle_of_view, {5, 120}, "of the picture's width").unit("degrees");
    keys.integer("pixels", v.pixels, 64, 2048, "the width of the picture, which is 9/16 as high");
    keys.number("haze", v.haze, {1, 1e6}, "the distance at which haze is half of what is seen").unit("tiles");
    keys.integer("resolution", v.resolution, 16, 512, "pixels along a tile in layered depth images of level 0");
    keys.integer("levels", v.levels, 1, 7, "the number of levels of detail");
    keys.integer("directions", v.directions, 1, 32, "the number of directions from which tiles are sampled");
    keys.number("sample_size", v.sample_size, {0.25, 16},
                "the largest distance of samples in the picture, where tiles have a level for it")
        .unit("pixels");
}

void geometry_keys(Keys& keys, GeometryTileSettings& s)
{
    tile_keys(keys, s);
    keys.file("mesh", s.mesh, "the model of the plants: .obj, .ply, .off, .stl, .gltf or .glb; z is up", "a mesh")
        .otherwise("sunflowers");
    keys.integer("models", s.models, 1, 256, "the number of variations of the sunflower");
    if (keys.is_given("models") && !s.mesh.empty())
        throw keys.invalid("models", "cannot be combined with " + keys.name_of("mesh"));
    keys.number("facing", s.facing, {-360, 360}, "where heads look, from x towards y").unit("degrees");
    keys.number("spread", s.spread, {0, 180}, "the largest deviation from that").unit("degrees");
    keys.integers("field", s.view.field, {1, 512}, {"x", "y"}, "the number of tiles along x and y");
    keys.picture_or_formula("terrain", s.terrain,
                            "heights over the field: the light of a picture, or a formula in x and y from -1 to 1");
    keys.number("height", s.height, {-100, 100}, "how high 1 of the terrain is")
        .unit("tiles")
        .only_if(!s.terrain.empty(), "terrain");
    camera_keys(keys, s.view);
    if (!keys.is_read()) return;
    if (!s.terrain.empty())
        keys.check("terrain", [&] { values_of_text(s.terrain, "light", s.view.field[0], s.view.field[1]); });
    if (s.mesh.empty()) return;
    keys.check("mesh", [&] { s.model = std::make_shared<PlantModel>(plant_of_mesh(read_triangle_mesh(s.mesh))); });
    if (s.model->places.size() > most_mesh_vertices)
        throw keys.invalid("mesh", fmt::format("must have at most {} vertices", most_mesh_vertices));
    if (s.model->height > most_mesh_height)
        throw keys.invalid("mesh", fmt::format("must be at most {} times as high as it is wide", most_mesh_height / 2));
    for (const std::filesystem::path& file : files_beside_mesh(s.mesh)) keys.reads_too(file);
}

std::string geometry_label(const GeometryTileSettings& s)
{
    return s.mesh.empty() ? "Geometry tiles: sunflowers" : "Geometry tiles: " + name_of_input(s.mesh.string());
}

PoissonTileSet plant_tile_set(const GeometryTileSettings& s, std::uint64_t seed, const DistributionPlace& place)
{
    PoissonTileSet tiles;
    if (s.tiles.empty()) {
        PoissonTileParameters p = tile_parameters(s);
        p.seed = seed;
        tiles = cached_tile_set(p, place.engine, place.device, cache_folder(), place.on_step).set;
    } else {
        tiles = read_tile_set(s.tiles);
    }
    return tiles;
}

std::optional<Terrain> field_terrain(const GeometryTileSettings& s)
{
    InstanceSettings instances;
    instances.terrain = s.terrain;
    instances.terrain_area = {0, 0, static_cast<double>(s.view.field[0]), static_cast<double>(s.view.field[1])};
    instances.height = s.height;
    return terrain_of(instances);
}

DistributionTable cost_table(const std::vector<FieldCost>& costs)
{
    DistributionTable table{"Work by distance",
                            {"tiles away", "tiles", "samples drawn", "triangles of the scene", "samples a triangle"},
                            {}};
    for (std::size_t k = 0; k < costs.size(); ++k) {
        const FieldCost& c = costs[k];
        if (c.tiles == 0) continue;
        table.rows.push_back(
            {fmt::format("{} to {}", k == 0 ? 0 : 1 << k, 2 << k), fmt::format("{}", c.tiles),
             fmt::format("{}", c.samples), fmt::format("{}", c.triangles),
             c.triangles > 0 ? fmt::format("{:.3g}", static_cast<double>(c.samples) / static_cast<double>(c.triangles))
                             : "-"});
    }
    return table;
}

DistributionTable level_table(const LayeredTiles& images, const FieldSettings& view)
{
    DistributionTable table{"Samples of the first tile, by level and direction", {"level", "pixels a tile"}, {}};
    for (std::uint32_t k = 0; k < view.directions; ++k)
        table.columns.push_back(fmt::format("{:.4g} degrees", 360.0 * k / view.directions));
    for (int level = 0; level < static_cast<int>(view.levels); ++level) {
        table.rows.push_back({std::to_string(level), fmt::format("{:.4g}", view.resolution / std::exp2(level))});
        for (std::uint32_t k = 0; k < view.directions; ++k)
            table.rows.back().push_back(std::to_string(images.at({0, k, level}).samples.size()));
    }
    return table;
}

DistributionResult make_geometry_tiles(const GeometryTileSettings& s, std::uint64_t seed,
                                       const DistributionPlace& place, DistributionFiles& files)
{
    PoissonTileSet tiles = plant_tile_set(s, seed, place);
    const double radius = plant_radius(tiles);
    std::vector<PlantModel> models = s.mesh.empty() ? sunflower_models(s.models) : std::vector{*s.model};
    const double degree = std::numbers::pi / 180;
    const PlantLooks looks{static_cast<std::uint32_t>(models.size()),
                           {0.8, 1},
                           {(s.facing - s.spread) * degree, (s.facing + s.spread) * degree}};
    const PlantTileSet set(std::move(tiles), radius, looks, std::move(models));
    const PoissonTiling tiling{stream_key(seed, Purpose::tile_choice, 0)[0], 0};
    const PlantField field(set, tiling, s.view, field_terrain(s));

    LayeredTiles images(set, s.view);
    std::vector<LayeredTiles::Key> keys = field.needed();
    for (std::uint32_t k = 0; k < s.view.directions; ++k)
        for (int level = 0; level < static_cast<int>(s.view.levels); ++level) keys.emplace_back(0, k, level);
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    images.make(keys);

    DistributionResult result;
    const auto add = [&](const std::string& name, const PngPixels& pixels, std::string caption) {
        write_png(files.add(name), pixels);
        result.pictures.push_back({name, std::move(caption)});
    };
    const PngPixels layered = field.layered(images), whole = field.whole();
    const PictureDifference difference = difference_of(layered, whole);
    const auto [gaps, spill] =
        cover_errors(field.layered(images, FieldColors::cover), field.whole(0, FieldColors::cover));
    const PictureDifference aliasing = difference_of(field.whole(0.5), whole);
    add("field.png", layered,
        "The field, by layered depth images of its tiles, drawn from the farthest to the nearest.");
    add("whole.png", whole, "The whole scene: all triangles of all plants.");
    add("difference.png", difference.picture, "Twice the difference of both, darker for more.");
    add("levels.png", field.layered(images, FieldColors::levels),
        "Levels of detail: red, yellow, green, cyan, blue, violet, orange, from the finest.");
    add("plan.png", field.plan(),
        "The tiles that may be seen, from above, in the colours of their levels; every other direction is darker.");
    add("tile.png", images.sheet(),
        "Layered depth images of a tile: a column for each direction, a row for each level.");
    const std::vector<FieldCost> costs = field.costs(images);
    FieldCost sum;
    for (const FieldCost& c : costs) sum = {sum.tiles + c.tiles, sum.samples + c.samples, sum.triangles + c.triangles};
    std::uint64_t stored = 0;
    for (const LayeredTiles::Key& key : field.needed()) stored += images.at(key).samples.size();
    result.facts = {fmt::format("{} {} tiles of {} plants", set.tiles.parameters.tiles, kind_name(set.tiles.parameters),
                                set.tiles.parameters.points_per_tile),
                    fmt::format("a field of {} x {} tiles", s.view.field[0], s.view.field[1])};
    result.numbers = {
        {"tiles_seen", "Tiles seen", static_cast<double>(sum.tiles), "that may be in the picture"},
        {"samples", "Samples drawn", static_cast<double>(sum.samples), "of layered depth images"},
        {"triangles", "Triangles", static_cast<double>(sum.triangles), "of the plants in these tiles"},
        {"images", "Images", static_cast<double>(field.needed().size()),
         "layered depth images that the picture needs, by tile, direction and level"},
        {"stored", "Samples stored", static_cast<double>(stored),
         fmt::format("in these, of {} bytes each", sizeof(DepthSample))},
        {"difference", "Difference", difference.mean, "of 255: mean over pixels, of the field and the whole scene"},
        {"root_mean_square", "Root mean square", difference.root_mean_square, "of the same differences"},
        {"brightness", "Brightness", difference.signed_mean,
         "of 255: how much brighter the field is than the whole scene, on average"},
        {"gaps", "Gaps", gaps, "part of what plants cover in the whole scene that the field leaves open"},
        {"spill", "Spill", spill, "what the field covers beside it, over what plants cover"},
        {"aliasing", "Aliasing", aliasing.mean,
         "mean difference of the whole scene from itself, moved by half a sample"},
        {"aliasing_square", "Aliasing, root mean square", aliasing.root_mean_square, "of the same differences"}};
    result.tables = {cost_table(costs), level_table(images, s.view)};
    return result;
}

}

Kind geometry_tile_kind()
{
    return make_kind<GeometryTileSettings>({"distribution", "geometry-tiles", "", "Geometry tiles",
                                            "Draw a field of plants by layered depth images of tiles"},
                                           geometry_keys, geometry_label, make_geometry_tiles);
}

}
