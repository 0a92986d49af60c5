// poissonlab texture export: a texture set for engines.
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "experiment/run/progress.hpp"
#include "reports/engine/look_up_texts.hpp"
#include "reports/engine/texture_pages.hpp"
#include "results/own_files.hpp"
#include "tiles/texture/engine/engine_texture.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr auto texture_export_notes =
    R"(Every level of a tile is made of the tile's own texels: no level mixes tiles that lie side by side in the atlas only.
Bytes of colours are averaged as light, other numbers as they are.
  dds     atlas.dds, the packed atlas, and tiles.dds, an array with a layer for each tile; atlas-NAME.dds and
          tiles-NAME.dds of companions. Without compression, header DX10
  ktx2    the same as KTX2 files
  png     tiles/00000.png and so on, a picture for each layer (.exr of floating-point numbers)
  glsl    look_up.glsl: which tile is where, and its colours by hardware filters or exactly; GLSL 4.3 and ES 3.00
  hlsl    look_up.hlsl
  wgsl    look_up.wgsl
  mtlx    texture_tiles.mtlx, a node and a material of MaterialX, with texture_tiles.glsl and atlas.png
  page    plane.html, which flies over the plane in a browser
A tile's layer is its place in the packing, as runtime/texture_tiles.h counts; of sets without a packing, which have no
packed atlas, it is its number in texture.json. Bilinear look-ups in the packed atlas are right at levels with 2^level <=
ring; layers are for look-ups that fetch each texel through its own tile.
--normals NAME adds NAME-normals to the maps, of the companion that has heights: of the finished tiles, without seams in
any tiling; red is east, green north.
  poissonlab texture build corner --colors 3 --exemplar rock.png --also height.png --size 64 --out rock
  poissonlab texture export rock --normals height --relief 12 --out engine)";

enum class EngineFiles
{
    dds,
    ktx2,
    png,
    glsl,
    hlsl,
    wgsl,
    mtlx,
    page,
};
constexpr WordTable<EngineFiles, 8> engine_files{{{{EngineFiles::dds, "dds"},
                                                   {EngineFiles::ktx2, "ktx2"},
                                                   {EngineFiles::png, "png"},
                                                   {EngineFiles::glsl, "glsl"},
                                                   {EngineFiles::hlsl, "hlsl"},
                                                   {EngineFiles::wgsl, "wgsl"},
                                                   {EngineFiles::mtlx, "mtlx"},
                                                   {EngineFiles::page, "page"}}}};

constexpr double usual_relief = 8;

constexpr auto page_name = "plane.html";

struct TextureExportOptions
{
    std::filesystem::path folder, out;
    std::vector<std::string> formats;
    std::string normals;
    double relief = std::numeric_limits<double>::quiet_NaN(); ///< not given: usual_relief
    bool as_json = false;
    bool quiet = false;
};

/// The set's folder as a person calls it.
std::string set_name(const TextureExportOptions& o)
{
    const std::filesystem::path folder = o.folder.has_filename() ? o.folder : o.folder.parent_path();
    return printable(folder.filename().string());
}

/// Writes the files, and lists them in their order.
struct EngineExport
{
    const TextureExportOptions& options;
    const TextureSet& set;
    std::vector<std::string> files;

    bool wants(EngineFiles kind) const
    {
        return options.formats.empty() || std::ranges::count(options.formats, engine_files[kind]) > 0;
    }

    std::filesystem::path place(const std::string& name)
    {
        files.push_back(name);
        return options.out / name;
    }

    void write_textures(const std::string& name, const GpuTexture& texture)
    {
        if (wants(EngineFiles::dds)) write_whole_file(place(name + ".dds"), dds_file(texture));
        if (wants(EngineFiles::ktx2)) write_whole_file(place(name + ".ktx2"), ktx2_file(texture));
    }

    void write_layers(const std::string& folder, const RawPicture& level)
    {
        make_folder(options.out / folder);
        const AtlasLayout layout = atlas_layout(set);
        const std::vector<std::size_t> layers = tile_layers(set);
        for (std::size_t tile = 0; tile < layers.size(); ++tile)
            write_raw_picture(options.out / folder / fmt::format("{:05}{}", layers[tile], raw_ending(level.type)),
                              tile_of_level(level, layout, tile));
        files.push_back(folder);
    }

    void write_map(const EngineMap& map)
    {
        const std::string name = map.name.empty() ? "" : "-" + map.name;
        if (wants(EngineFiles::dds) || wants(EngineFiles::ktx2)) {
            if (has_places(set)) write_textures("atlas" + name, packed_texture(map, set.size));
            write_textures("tiles" + name, layered_texture(map, set));
        }
        if (wants(EngineFiles::png)) write_layers("tiles" + name, encoded_level(map));
    }

    /// Texts in which the hash finds tiles.
    void write_texts()
    {
        if (wants(EngineFiles::glsl)) write_whole_file(place("look_up.glsl"), glsl_look_up(set));
        if (wants(EngineFiles::hlsl)) write_whole_file(place("look_up.hlsl"), hlsl_look_up(set));
        if (wants(EngineFiles::wgsl)) write_whole_file(place("look_up.wgsl"), wgsl_look_up(set));
        if (wants(EngineFiles::mtlx)) {
            write_whole_file(place("texture_tiles.glsl"), materialx_function(set));
            write_whole_file(place("texture_tiles.mtlx"), materialx_document(set, "atlas.png", "texture_tiles.glsl"));
            const PngPixels atlas = atlas_of(set);
            write_png(place("atlas.png"), atlas);
        }
        if (wants(EngineFiles::page)) write_whole_file(place(page_name), render_plane_page(set, set_name(options)));
    }

    static void make_folder(const std::filesystem::path& folder)
    {
        std::error_code problem;
        std::filesystem::create_directories(folder, problem);
        if (problem) throw StorageError(fmt::format("{}: cannot be made: {}", folder.string(), problem.message()));
    }
};

/// Arrays of textures have at most so many layers in Direct3D 12 and by the least that Vulkan's drivers have today.
constexpr std::size_t most_layers = 2048;

void print_exported(const EngineExport& all, std::size_t maps)
{
    const int levels = tile_levels(all.set.size);
    if (all.options.as_json) {
        const nlohmann::ordered_json json{{"folder", printable(all.options.out.string())},
                                          {"files", all.files},
                                          {"maps", maps},
                                          {"layers", all.set.tiles.size()},
                                          {"levels", levels}};
        fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
        return;
    }
    if (all.options.quiet) return;
    fmt::print("{}: {} of {} tiles of {} x {} texels, {} levels\n", printable(all.options.out.string()),
               maps == 1 ? "a map" : fmt::format("{} maps", maps), all.set.tiles.size(), all.set.size, all.set.size,
               levels);
    for (const std::string& file : all.files) fmt::print("  {}\n", printable(file));
    if (all.set.tiles.size() > most_layers)
        fmt::print("{} layers are more than the {} that graphics cards have to allow\n", all.set.tiles.size(),
                   most_layers);
}

void check_export(const TextureExportOptions& o)
{
    for (const std::string& word : o.formats) value_of_word("texture export", "--formats", word, engine_files);
    if (!std::isnan(o.relief) && !(o.relief > 0 && o.relief <= 10'000))
        throw InputError(
            fmt::format("texture export: --relief {}: must be a number greater than 0 and at most 10000", o.relief));
    if (!std::isnan(o.relief) && o.normals.empty())
        throw InputError("texture export: --relief: needs --normals: it sets the height that the normals are for");
    check_output_folder(o.out, "texture export: ");
    const bool has_page = o.formats.empty() || std::ranges::find(o.formats, "page") != o.formats.end();
    if (has_page) check_own_page(o.out / page_name);
}

/// Throws InputError where texts are asked for that a set without places has not.
void check_places(const TextureExportOptions& o, const TextureSet& set)
{
    for (const std::string& word : o.formats)
        if (!has_places(set) && *engine_files.find(word) > EngineFiles::png)
            throw InputError(fmt::format("texture export: --formats {}: is for complete sets of corner or Wang tiles, "
                                         "which a hash lays; {} are laid in scanlines",
                                         word, printable(o.folder.string())));
}

void export_texture(const TextureExportOptions& o)
{
    check_export(o);
    const TextureSet set = read_texture_set(o.folder);
    const std::vector<EngineMap> maps = [&] {
        try {
            return engine_maps(o.folder, set, o.normals, std::isnan(o.relief) ? usual_relief : o.relief);
        } catch (const InputError& error) {
            if (!error.place().file.empty()) throw;
            throw error.moved_to({"texture export"});
        }
    }();
    check_places(o, set);
    EngineExport all{o, set, {}};
    EngineExport::make_folder(o.out);
    for (const EngineMap& map : maps) all.write_map(map);
    if (has_places(set)) all.write_texts();
    print_exported(all, maps.size());
}

}

Command texture_export_command()
{
    const auto o = std::make_shared<TextureExportOptions>();
    return {"export",
            "Write a texture set for engines: textures with levels within tiles, look-ups for shaders, a page",
            {{"DIR", &o->folder, "The folder of a texture set, from texture build"},
             {"--formats", &o->formats, "dds, ktx2, png, glsl, hlsl, wgsl, mtlx or page; may be repeated; default: all",
              "NAME"},
             {"--normals", &o->normals, "The companion whose heights get normals", "NAME"},
             {"--relief", &o->relief,
              "The height of a companion from black to white, or from 0 to 1, in texels; default: 8", "TEXELS"},
             {"--out", &o->out, "The folder of the files", "DIR", required},
             quiet_option(o->quiet),
             json_option(o->as_json)},
            texture_export_notes,
            action_on(o, export_texture)};
}

}
