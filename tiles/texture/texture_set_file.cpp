// A texture tile set as a folder of pictures and a JSON file: docs/texture-set.md.
#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/files/json_members.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"
#include "tiles/texture/companion_maps.hpp"
#include "tiles/texture/marked_tiles.hpp"
#include "tiles/texture/texture_set.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <type_traits>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

constexpr auto atlas_name = "atlas.png";
constexpr auto sources_name = "sources.png";
constexpr auto exemplar_name = "exemplar.png";
constexpr auto json_name = "texture.json";
constexpr auto format_words = "poissonlab texture set";

/// A tile with its place in the atlas.
struct StoredTextureTile
{
    TextureTile tile;
    int column = 0;
    int row = 0;
};

template <Stored<StoredTextureTile> Tile>
void members(JsonMembers& m, Tile& tile)
{
    m.member("index", tile.tile.index);
    m.if_any("variant", tile.tile.variant);
    m.member("column", tile.column);
    m.member("row", tile.row);
}

template <Stored<CompanionMap> Map>
void name_companion(JsonMembers& m, Map& map)
{
    m.file_name("picture", map.picture_file);
    m.file_name("atlas", map.atlas_file);
    m.if_any("original", map.is_original);
    m.member("hash", map.hash);
}

/// The contents of the JSON file; the pictures' checksums are those of their pixels.
struct StoredTextureSet
{
    std::string format = format_words;
    TextureSet set; ///< without pixels
    int channels = 1;
    int columns = 1;
    int rows = 1;
    std::string exemplar_hash, atlas_hash, sources_hash;
    std::vector<StoredTextureTile> tiles;
};

template <Stored<StoredTextureSet> Set>
void members(JsonMembers& m, Set& stored)
{
    m.member("format", stored.format);
    m.word("kind", stored.set.kind, texture_kinds.all());
    m.member("horizontal_colors", stored.set.colors.horizontal, 2);
    m.member("vertical_colors", stored.set.colors.vertical, 2);
    m.member("tile_size", stored.set.size, 2);
    m.member("ring", stored.set.ring);
    if (m.is_there("color_classes", stored.set.classes != 1)) m.member("color_classes", stored.set.classes, 1);
    m.if_any("marked_column", stored.set.marked_column);
    m.member("smoothed", stored.set.is_smoothed);
    if (m.is_there("blended", stored.set.is_blended)) m.member("blended", stored.set.is_blended);
    if (m.is_there("levelled", stored.set.is_levelled)) m.member("levelled", stored.set.is_levelled);
    m.member("channels", stored.channels, 1);
    m.member("atlas_columns", stored.columns, 1);
    m.member("atlas_rows", stored.rows, 1);
    m.member("exemplar_hash", stored.exemplar_hash);
    m.member("atlas_hash", stored.atlas_hash);
    m.member("sources_hash", stored.sources_hash);
    m.objects("tiles", stored.tiles);
    if (m.is_there("companions", !stored.set.companions.empty()))
        m.objects("companions", stored.set.companions,
                  [](JsonMembers& of_map, auto& map) { name_companion(of_map, map); });
    m.group("parameters", [&](JsonMembers& of_parameters) {
        if constexpr (std::is_const_v<Set>)
            for (const auto& [name, value] : stored.set.parameters) of_parameters.member(name, value);
        else
            for (const std::string& name : of_parameters.stored().names())
                stored.set.parameters[name] = of_parameters.stored().text(name);
    });
}

template <class Value>
std::string hash_text(const std::vector<Value>& values)
{
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
    return fmt::format("{:016x}", xxh64_bytes(bytes));
}

/// The sources of all tiles in their places in the atlas: column, row, 0.
DeepPixels source_picture(const TextureSet& set, const AtlasLayout& layout)
{
    DeepPixels picture{layout.columns * set.size, layout.rows * set.size, 3, {}};
    picture.values.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height) * 3);
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile)
        for (std::size_t i = 0; i < set.pixels_a_tile(); ++i) {
            const auto size = static_cast<std::size_t>(set.size);
            const std::size_t x = static_cast<std::size_t>(layout.places[tile].first) * size + i % size;
            const std::size_t y = static_cast<std::size_t>(layout.places[tile].second) * size + i / size;
            const std::size_t at = (y * static_cast<std::size_t>(picture.width) + x) * 3;
            picture.values[at] = set.sources_of(tile)[i].x;
            picture.values[at + 1] = set.sources_of(tile)[i].y;
        }
    return picture;
}

/// Throws InputError where the pixels are not those that the JSON file was written for.
template <class Pixels>
void check_pixels(const fs::path& file, const Pixels& pixels, int width, int height, int channels,
                  const std::string& hash)
{
    if (pixels.width != width || pixels.height != height || pixels.channels != channels)
        throw InputError::at({file.string()},
                             fmt::format("{} x {} pixels with {} channels: must be {} x {} with {}", pixels.width,
                                         pixels.height, pixels.channels, width, height, channels));
    if (hash_text(pixels.values) != hash)
        throw InputError::at({file.string()}, fmt::format("is damaged, or not the picture of this {}", json_name));
}

template <class Read>
auto read_pixels(const fs::path& file, const Read& read)
{
    try {
        return read(file);
    } catch (const StorageError& error) {
        throw InputError(error.what());
    }
}

/// Throws InputError for numbers that do not go together.
void check_texture_numbers(const fs::path& file, const StoredTextureSet& stored)
{
    const TextureSet& set = stored.set;
    const auto refuse = [&](const std::string& problem) { throw InputError::at({file.string()}, problem); };
    if (stored.format != format_words) refuse(fmt::format("is no texture set: format = {}", stored.format));
    if (set.colors.horizontal > max_colors || set.colors.vertical > max_colors)
        refuse(fmt::format("more than {} colours", max_colors));
    if (set.has_corners() && set.colors.horizontal != set.colors.vertical)
        refuse("horizontal_colors and vertical_colors differ, for corners");
    const Color colors_a_class = set.has_corners() ? 2 : 4;
    if (set.classes > 2 || (set.classes == 2 &&
                            (set.colors.horizontal % colors_a_class != 0 || set.colors.vertical % colors_a_class != 0)))
        refuse(fmt::format("color_classes = {}: must be 1 or, for corners over an even number of colours and for edges "
                           "over a multiple of 4, 2",
                           set.classes));
    if (set.marked_column > 0 && set.classes != 2)
        refuse(fmt::format("marked_column = {}: is for color_classes = 2", set.marked_column));
    if (set.size % 2 != 0 || set.size > most_tile_pixels)
        refuse(fmt::format("tile_size = {}: must be even and at most {}", set.size, most_tile_pixels));
    if (set.ring > set.size / 2) refuse(fmt::format("ring = {}: must be at most half of tile_size", set.ring));
    if (stored.channels != 1 && stored.channels != 3) refuse("channels: must be 1 or 3");
    if (stored.tiles.empty()) refuse("there are no tiles");
    const std::uint64_t pairs = std::uint64_t{set.colors.horizontal} * set.colors.vertical;
    for (const StoredTextureTile& tile : stored.tiles)
        if (tile.tile.index >= pairs * pairs) refuse(fmt::format("tile {}: has other colours", tile.tile.index));
    if (set.classes == 2 && !set.has_corners())
        for (const StoredTextureTile& tile : stored.tiles)
            if (!agrees_on_marks(wang_tile(tile.tile.index, set.colors)))
                refuse(fmt::format("tile {}: its edges do not agree on the marks of its corners", tile.tile.index));
}

/// The layout follows from the tiles; the file repeats it for other programs.
void check_layout(const fs::path& file, const StoredTextureSet& stored)
{
    const AtlasLayout layout = atlas_layout(stored.set);
    bool is_same = layout.columns == stored.columns && layout.rows == stored.rows;
    for (std::size_t i = 0; i < stored.tiles.size(); ++i)
        is_same = is_same && layout.places[i] == std::pair(stored.tiles[i].column, stored.tiles[i].row);
    if (!is_same) throw InputError::at({file.string()}, "tiles lie elsewhere in the atlas");
}

StoredTextureSet read_json(const fs::path& file)
{
    const nlohmann::json json = read_json_file(file);
    StoredTextureSet stored;
    JsonMembers m{StoredObject(json, file)};
    members(m, stored);
    check_texture_numbers(file, stored);
    for (const StoredTextureTile& tile : stored.tiles) stored.set.tiles.push_back(tile.tile);
    check_layout(file, stored);
    return stored;
}

/// The part of a picture of all tiles that is a tile's, appended.
template <class Value, class Append>
void append_tile(const std::vector<Value>& picture, int channels, int columns, int size, std::pair<int, int> place,
                 const Append& append)
{
    const auto width = static_cast<std::size_t>(columns) * static_cast<std::size_t>(size);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const auto x = static_cast<std::size_t>(place.first * size + column);
            const auto y = static_cast<std::size_t>(place.second * size + row);
            append(&picture[(y * width + x) * static_cast<std::size_t>(channels)]);
        }
}

}

void write_texture_set(const fs::path& folder, const TextureSet& set)
{
    std::error_code problem;
    fs::create_directories(folder, problem);
    if (problem) throw StorageError(fmt::format("{}: cannot be made: {}", folder.string(), problem.message()));
    remove_other_companions(folder, set);
    write_texture_files([&](const std::string& name) { return folder / name; }, set);
}

void write_texture_files(const std::function<fs::path(const std::string& name)>& place, const TextureSet& set)
{
    const AtlasLayout layout = atlas_layout(set);
    const PngPixels atlas = atlas_of(set);
    const DeepPixels sources = source_picture(set, layout);
    StoredTextureSet stored{format_words,
                            {},
                            set.exemplar.channels,
                            layout.columns,
                            layout.rows,
                            hash_text(set.exemplar.values),
                            hash_text(atlas.values),
                            hash_text(sources.values),
                            {}};
    stored.set.kind = set.kind;
    stored.set.colors = set.colors;
    stored.set.size = set.size;
    stored.set.ring = set.ring;
    stored.set.classes = set.classes;
    stored.set.marked_column = set.marked_column;
    stored.set.is_smoothed = set.is_smoothed;
    stored.set.is_blended = set.is_blended;
    stored.set.is_levelled = set.is_levelled;
    stored.set.parameters = set.parameters;
    for (const CompanionMap& map : set.companions)
        stored.set.companions.push_back({map.picture_file, map.atlas_file, map.is_original, map.hash, {}});
    for (std::size_t i = 0; i < set.tiles.size(); ++i)
        stored.tiles.push_back({set.tiles[i], layout.places[i].first, layout.places[i].second});
    write_png(place(exemplar_name), set.exemplar);
    write_png(place(atlas_name), atlas);
    write_deep_png(place(sources_name), sources);
    write_companions(place, set);
    const auto& written = stored;
    write_whole_file(place(json_name), json_text([&](JsonMembers& m) { members(m, written); }, 2) + "\n");
}

TextureSet read_texture_set(const fs::path& folder)
{
    if (fs::is_regular_file(folder))
        throw InputError::at({folder.string()}, "is a file: must be the folder of a texture set (see texture build)");
    StoredTextureSet stored = read_json(folder / json_name);
    TextureSet set = std::move(stored.set);
    set.exemplar = read_pixels(folder / exemplar_name, read_png);
    check_pixels(folder / exemplar_name, set.exemplar, set.exemplar.width, set.exemplar.height, stored.channels,
                 stored.exemplar_hash);
    if (set.marked_column > 0 && set.marked_column >= set.exemplar.width)
        throw InputError::at({(folder / json_name).string()},
                             fmt::format("marked_column = {}: must be below the exemplar's width, {}",
                                         set.marked_column, set.exemplar.width));
    const PngPixels atlas = read_pixels(folder / atlas_name, read_png);
    const DeepPixels sources = read_pixels(folder / sources_name, read_deep_png);
    const int width = stored.columns * set.size, height = stored.rows * set.size;
    check_pixels(folder / atlas_name, atlas, width, height, stored.channels, stored.atlas_hash);
    check_pixels(folder / sources_name, sources, width, height, 3, stored.sources_hash);
    for (const StoredTextureTile& tile : stored.tiles) {
        const std::pair place(tile.column, tile.row);
        append_tile(atlas.values, stored.channels, stored.columns, set.size, place, [&](const std::uint8_t* pixel) {
            set.values.insert(set.values.end(), pixel, pixel + stored.channels);
        });
        append_tile(sources.values, 3, stored.columns, set.size, place, [&](const std::uint16_t* pixel) {
            if (pixel[0] >= set.exemplar.width || pixel[1] >= set.exemplar.height)
                throw InputError::at({(folder / sources_name).string()}, "a source outside of the exemplar");
            set.sources.push_back({pixel[0], pixel[1]});
        });
    }
    return set;
}

}
