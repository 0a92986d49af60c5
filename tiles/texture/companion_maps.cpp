#include "tiles/texture/companion_maps.hpp"

#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/files/stored_object.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <vector>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

std::string sample_hash(const RawPicture& picture)
{
    return fmt::format("{:016x}", xxh64_bytes(std::string_view(reinterpret_cast<const char*>(picture.bytes.data()),
                                                               picture.bytes.size())));
}

/// Calls visit(column, row, source) for each pixel of each tile, by its place in the atlas.
template <class Visit>
void visit_sources(const TextureSet& set, const AtlasLayout& layout, const Visit& visit)
{
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile) {
        const auto [tile_column, tile_row] = layout.places[tile];
        const auto sources = set.sources_of(tile);
        for (int row = 0; row < set.size; ++row)
            for (int column = 0; column < set.size; ++column)
                visit(tile_column * set.size + column, tile_row * set.size + row,
                      sources[static_cast<std::size_t>(row * set.size + column)]);
    }
}

/// Throws InputError for pictures of other sizes than those of the set, or of different kinds of numbers.
void check_pictures(const fs::path& picture_file, const RawPicture& picture, const fs::path& atlas_file,
                    const RawPicture& atlas, const TextureSet& set, const AtlasLayout& layout)
{
    const auto check_size = [](const fs::path& file, const RawPicture& one, int width, int height) {
        if (one.width != width || one.height != height)
            throw InputError::at({file.string()},
                                 fmt::format("{} x {} pixels: must be {} x {}", one.width, one.height, width, height));
    };
    check_size(picture_file, picture, set.exemplar.width, set.exemplar.height);
    check_size(atlas_file, atlas, layout.columns * set.size, layout.rows * set.size);
    if (picture.type != atlas.type || picture.channels != atlas.channels)
        throw InputError::at({atlas_file.string()},
                             fmt::format("{} channels of {}: must be {} of {}, as those of {}", atlas.channels.size(),
                                         sample_types[atlas.type], picture.channels.size(), sample_types[picture.type],
                                         printable(picture_file.filename().string())));
}

/// The files that a stored set names; none where there is no set.
std::vector<std::string> stored_companion_files(const fs::path& file)
{
    std::vector<std::string> names;
    try {
        const nlohmann::json json = read_json_file(file);
        const StoredObject set(json, file);
        if (!set.has("companions")) return names;
        for (const StoredObject& map : set.objects("companions"))
            for (const char* member : {"picture", "atlas"}) names.push_back(map.file_name(member));
    } catch (const InputError&) { // whatever it is, it is written anew
    }
    return names;
}

}

CompanionMap companion_map(const std::string& name, RawPicture picture, bool is_original)
{
    const std::string file = name + raw_ending(picture.type);
    std::string hash = sample_hash(picture);
    return {"exemplar-" + file, "atlas-" + file, is_original, std::move(hash), std::move(picture)};
}

void set_picture(CompanionMap& companion, RawPicture picture)
{
    companion.hash = sample_hash(picture);
    companion.picture = std::move(picture);
}

RawPicture companion_atlas(const TextureSet& set, const RawPicture& picture)
{
    const AtlasLayout layout = atlas_layout(set);
    RawPicture atlas{layout.columns * set.size, layout.rows * set.size, picture.type, picture.channels, {}};
    atlas.bytes.resize(atlas.at(0, atlas.height));
    visit_sources(set, layout, [&](int column, int row, SourcePixel source) {
        std::copy_n(&picture.bytes[picture.at(source.x, source.y)], picture.pixel_bytes(),
                    &atlas.bytes[atlas.at(column, row)]);
    });
    return atlas;
}

void write_companions(const std::function<fs::path(const std::string& name)>& place, const TextureSet& set)
{
    for (const CompanionMap& map : set.companions) {
        write_raw_picture(place(map.picture_file), map.picture);
        write_raw_picture(place(map.atlas_file), companion_atlas(set, map.picture));
    }
}

void remove_other_companions(const fs::path& folder, const TextureSet& set)
{
    const auto is_kept = [&](const std::string& name) {
        return std::ranges::any_of(set.companions, [&](const CompanionMap& map) {
            return map.picture_file == name || map.atlas_file == name;
        });
    };
    for (const std::string& name : stored_companion_files(folder / "texture.json")) {
        const bool is_ours = name.starts_with("exemplar-") || name.starts_with("atlas-");
        std::error_code ignored;
        if (is_ours && !is_kept(name)) fs::remove(folder / name, ignored);
    }
}

std::size_t certify_companion(const fs::path& folder, const TextureSet& set, const CompanionMap& map)
{
    const fs::path picture_file = folder / map.picture_file, atlas_file = folder / map.atlas_file;
    const RawPicture picture = read_raw_picture(picture_file), atlas = read_raw_picture(atlas_file);
    const AtlasLayout layout = atlas_layout(set);
    check_pictures(picture_file, picture, atlas_file, atlas, set, layout);
    if (sample_hash(picture) != map.hash)
        throw InputError::at({picture_file.string()}, "is damaged, or not the picture of this texture.json");
    std::size_t pixels = 0;
    visit_sources(set, layout, [&](int column, int row, SourcePixel source) {
        const std::uint8_t* const asked = &picture.bytes[picture.at(source.x, source.y)];
        if (!std::equal(asked, asked + picture.pixel_bytes(), &atlas.bytes[atlas.at(column, row)]))
            throw InputError::at({atlas_file.string()},
                                 fmt::format("the pixel in column {}, row {} is not that of {} in column {}, row {}",
                                             column, row, printable(map.picture_file), source.x, source.y));
        ++pixels;
    });
    return pixels;
}

}
