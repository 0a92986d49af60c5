#include "tiles/texture/engine/engine_texture.hpp"

#include <optional>

namespace poissonlab {
namespace {

/// The format that holds all numbers: of colours there is one with four channels alone.
GpuFormat format_of(const EngineMap& map)
{
    if (map.type == SampleType::real) return map.channels == 1 ? GpuFormat::r32f : GpuFormat::rgba32f;
    if (map.type == SampleType::word) return map.channels == 1 ? GpuFormat::r16 : GpuFormat::rgba16;
    if (map.meaning == MapMeaning::colors) return GpuFormat::rgba8_srgb;
    return map.channels == 1 ? GpuFormat::r8 : GpuFormat::rgba8;
}

/// A number of 1 and one of 0, in the bytes that the picture has.
std::string constant(SampleType type, bool is_one)
{
    if (!is_one) return std::string(type == SampleType::byte ? 1 : type == SampleType::word ? 2 : 4, '\0');
    if (type == SampleType::real) return std::string("\0\0\x80\x3f", 4);
    return std::string(type == SampleType::byte ? 1 : 2, '\xff');
}

/// Which of a picture's channels a format's channel shows, if it has one: grey colours become equal ones.
std::optional<std::size_t> shown_channel(std::size_t channel, std::size_t channels, bool is_color)
{
    if (is_color && channels <= 2)
        return channel < 3 ? 0 : channels == 2 ? std::optional<std::size_t>(1) : std::nullopt;
    return channel < channels ? std::optional(channel) : std::nullopt;
}

/// The picture with the format's channels: missing ones are 0, a missing alpha is 1.
std::string texels_of(const RawPicture& picture, GpuFormat format, MapMeaning meaning)
{
    const std::size_t sample = picture.pixel_bytes() / picture.channels.size(), wanted = texel_bytes(format) / sample;
    std::vector<std::optional<std::size_t>> shown(wanted);
    for (std::size_t c = 0; c < wanted; ++c)
        shown[c] = shown_channel(c, picture.channels.size(), meaning == MapMeaning::colors);
    std::string texels;
    const std::size_t end = picture.at(0, picture.height);
    texels.reserve(end / picture.pixel_bytes() * texel_bytes(format));
    for (std::size_t at = 0; at < end; at += picture.pixel_bytes())
        for (std::size_t c = 0; c < wanted; ++c)
            if (shown[c])
                texels.append(reinterpret_cast<const char*>(&picture.bytes[at + *shown[c] * sample]), sample);
            else
                texels += constant(picture.type, c == 3);
    return texels;
}

}

std::vector<std::size_t> tile_layers(const TextureSet& set)
{
    const AtlasLayout layout = atlas_layout(set);
    const bool is_packed = has_places(set);
    std::vector<std::size_t> layers(set.tiles.size());
    for (std::size_t tile = 0; tile < layers.size(); ++tile) {
        const auto [column, row] = layout.places[tile];
        layers[tile] = is_packed ? static_cast<std::size_t>((layout.rows - 1 - row) * layout.columns + column) : tile;
    }
    return layers;
}

GpuTexture packed_texture(const EngineMap& map, int tile_size)
{
    GpuTexture texture{format_of(map), map.width, map.height, 1, false, {}};
    const EngineMap* level = &map; // large: the first one is not copied
    EngineMap half;
    for (int left = tile_levels(tile_size); left > 0; --left) {
        texture.levels.push_back(texels_of(encoded_level(*level), texture.format, map.meaning));
        if (left == 1) break;
        half = halved(*level);
        level = &half;
    }
    return texture;
}

RawPicture tile_of_level(const RawPicture& level, const AtlasLayout& layout, std::size_t tile)
{
    const int size = level.width / layout.columns;
    RawPicture picture{size, size, level.type, level.channels, {}};
    picture.bytes.reserve(picture.at(0, size));
    for (int row = 0; row < size; ++row) {
        const auto* const first =
            &level.bytes[level.at(layout.places[tile].first * size, layout.places[tile].second * size + row)];
        picture.bytes.insert(picture.bytes.end(), first, first + picture.at(0, 1));
    }
    return picture;
}

GpuTexture layered_texture(const EngineMap& map, const TextureSet& set)
{
    GpuTexture texture{format_of(map), set.size, set.size, static_cast<int>(set.tiles.size()), true, {}};
    const AtlasLayout layout = atlas_layout(set);
    const std::vector<std::size_t> layers = tile_layers(set);
    std::vector<std::size_t> tiles(layers.size());
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) tiles[layers[tile]] = tile;
    const EngineMap* level = &map; // large: the first one is not copied
    EngineMap half;
    for (int left = tile_levels(set.size); left > 0; --left) {
        const RawPicture picture = encoded_level(*level);
        std::string& texels = texture.levels.emplace_back();
        for (const std::size_t tile : tiles)
            texels += texels_of(tile_of_level(picture, layout, tile), texture.format, map.meaning);
        if (left == 1) break;
        half = halved(*level);
        level = &half;
    }
    return texture;
}

}
