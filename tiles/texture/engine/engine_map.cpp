#include "tiles/texture/engine/engine_map.hpp"

#include "base/errors/errors.hpp"
#include "base/images/srgb_light.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace poissonlab {
namespace {

// Normals of a texture set's heights, without seams in any tiling.
//
// Where two pieces of the exemplar meet, heights have a step, which is no slope of the surface: as a normal it would be
// a ridge along each cut. Slopes are therefore differences of texels that are neighbours in the exemplar as well: at a
// cut, those on the texel's own side. Across a border lies a texel that the shared colours decide, in a tiling and in
// the atlas: differences of neighbours in a packed atlas are those of every tiling.

/// Heights on the torus that a packed atlas is.
class PackedHeights
{
public:
    PackedHeights(const EngineMap& map, const TextureSet& set, double relief)
        : map_(map), size_(set.size), is_wang_(!set.has_corners()), relief_(relief), sources_(map.values.size())
    {
        const AtlasLayout layout = atlas_layout(set);
        for (std::size_t tile = 0; tile < set.tiles.size(); ++tile)
            for (int i = 0; i < size_ * size_; ++i)
                sources_[place(layout.places[tile].first * size_ + i % size_,
                               layout.places[tile].second * size_ + i / size_)] =
                    set.sources_of(tile)[static_cast<std::size_t>(i)];
    }

    /// The slopes to the east and to the north.
    std::pair<double, double> slopes(int column, int row) const
    {
        return {slope(column, row, 1, 0), slope(column, row, 0, -1)};
    }

private:
    std::size_t place(int column, int row) const
    {
        const auto x = static_cast<std::size_t>((column + map_.width) % map_.width),
                   y = static_cast<std::size_t>((row + map_.height) % map_.height);
        return y * static_cast<std::size_t>(map_.width) + x;
    }

    /// The mean difference to the neighbours ahead and behind that are neighbours in the exemplar.
    double slope(int column, int row, int dx, int dy) const
    {
        double sum = 0;
        int count = 0;
        for (const int sign : {1, -1}) {
            if (!is_joined(column, row, sign * dx, sign * dy)) continue;
            sum += sign * (map_.values[place(column + sign * dx, row + sign * dy)] - map_.values[place(column, row)]);
            ++count;
        }
        return count == 0 ? 0 : relief_ * sum / count;
    }

    /// Corner texels of Wang tiles, which are those of horizontal edges, have other neighbours beside them in a tiling.
    bool is_joined(int column, int row, int dx, int dy) const
    {
        const int in_column = column % size_, in_row = row % size_;
        if (is_wang_ && (in_row == 0 || in_row == size_ - 1) && in_column == (dx > 0 ? size_ - 1 : 0) && dx != 0)
            return false;
        const SourcePixel from = sources_[place(column, row)], to = sources_[place(column + dx, row + dy)];
        return to.x - from.x == dx && to.y - from.y == dy;
    }

    const EngineMap& map_;
    int size_;
    bool is_wang_;
    double relief_;
    std::vector<SourcePixel> sources_; ///< of the atlas' texels
};

void check_heights(const EngineMap& heights, const TextureSet& set)
{
    if (heights.channels != 1)
        throw InputError(fmt::format("{} has {} channels: heights must have 1", heights.name, heights.channels));
    if (!has_places(set))
        throw InputError(
            fmt::format("normals of {}: must be of a complete set of corner or Wang tiles, whose neighbours "
                        "in the atlas have the texels of those in a tiling",
                        heights.name));
    if (set.ring < 1)
        throw InputError(fmt::format("normals of {}: tiles must have a ring of at least 1 texel", heights.name));
}

/// Normals of heights from 0 to 1, which are `relief` texels high: (-dh/dx, -dh/dy, 1) at length 1, x going east and y
/// north, by differences of neighbours in the exemplar. 16 bits a channel. Throws InputError for sets whose tiles are
/// in no packing, those without a ring, and maps of several channels.
EngineMap height_normals(const EngineMap& heights, const TextureSet& set, double relief)
{
    check_heights(heights, set);
    EngineMap normals{
        heights.name + "-normals", MapMeaning::directions, SampleType::word, heights.width, heights.height, 3, {}};
    normals.values.reserve(3 * heights.values.size());
    const double unit = heights.type == SampleType::byte ? 255 : heights.type == SampleType::word ? 65535 : 1;
    const PackedHeights packed(heights, set, relief / unit);
    for (int row = 0; row < heights.height; ++row)
        for (int column = 0; column < heights.width; ++column) {
            const auto [east, north] = packed.slopes(column, row);
            const double length = std::sqrt(east * east + north * north + 1);
            for (const double part : {-east, -north, 1.0}) normals.values.push_back(part / length);
        }
    return normals;
}

/// The light of each 16-bit number of sRGB, as whole 2^-40: no last bit of a power decides anything.
const std::vector<double>& light_of_words()
{
    static const std::vector<double> all = [] {
        std::vector<double> light;
        for (int word = 0; word < 65536; ++word)
            light.push_back(std::round(light_of_srgb(word / 65535.0) * 0x1p40) * 0x1p-40);
        return light;
    }();
    return all;
}

/// The number whose light is nearest.
std::uint16_t word_of_light(double light)
{
    const std::vector<double>& all = light_of_words();
    const auto above = std::ranges::lower_bound(all, light);
    if (above == all.begin()) return 0;
    if (above == all.end()) return 65535;
    return static_cast<std::uint16_t>(above - all.begin() - (light - above[-1] < *above - light ? 1 : 0));
}

double decoded(const RawPicture& picture, std::size_t number, MapMeaning meaning)
{
    const bool is_color = meaning == MapMeaning::colors;
    if (picture.type == SampleType::byte) {
        const std::uint8_t byte = picture.bytes[number];
        return is_color ? static_cast<double>(light_of_bytes()[byte]) : byte;
    }
    if (picture.type == SampleType::word) {
        std::uint16_t word = 0;
        std::memcpy(&word, &picture.bytes[2 * number], sizeof(word));
        return is_color ? light_of_words()[word] : word;
    }
    float real = 0;
    std::memcpy(&real, &picture.bytes[4 * number], sizeof(real));
    return static_cast<double>(real);
}

EngineMap decoded_map(const std::string& name, const RawPicture& picture, MapMeaning meaning)
{
    EngineMap map{name, meaning, picture.type, picture.width, picture.height, static_cast<int>(picture.channels.size()),
                  {}};
    const std::size_t numbers = picture.at(0, picture.height) / picture.pixel_bytes() * picture.channels.size();
    map.values.reserve(numbers);
    const std::size_t alpha = picture.channels.size() % 2 == 0 ? picture.channels.size() - 1 : numbers;
    for (std::size_t i = 0; i < numbers; ++i) {
        const bool is_alpha = i % picture.channels.size() == alpha;
        map.values.push_back(decoded(picture, i, is_alpha ? MapMeaning::numbers : meaning));
    }
    return map;
}

/// The number that a file holds for a value, appended to its bytes.
void append_encoded(std::vector<std::uint8_t>& bytes, double value, SampleType type, MapMeaning meaning)
{
    const auto append = [&](auto number) {
        const auto all = std::bit_cast<std::array<std::uint8_t, sizeof(number)>>(number);
        bytes.insert(bytes.end(), all.begin(), all.end());
    };
    const double most = type == SampleType::byte ? 255 : 65535;
    if (meaning == MapMeaning::directions) value = (value + 1) / 2 * most;
    const auto nearest = [&] { return std::clamp(std::floor(value + 0.5), 0.0, most); };
    if (type == SampleType::real)
        append(static_cast<float>(value));
    else if (type == SampleType::word)
        append(meaning == MapMeaning::colors ? word_of_light(value) : static_cast<std::uint16_t>(nearest()));
    else
        append(meaning == MapMeaning::colors ? byte_of_light(static_cast<float>(value))
                                             : static_cast<std::uint8_t>(nearest()));
}

/// A companion's name: what stands between atlas- and the file's ending.
std::string companion_name(const CompanionMap& map)
{
    constexpr std::string_view prefix = "atlas-";
    const std::string stem = std::filesystem::path(map.atlas_file).stem().string();
    if (!stem.starts_with(prefix) || stem.size() == prefix.size())
        throw InputError(fmt::format("companion {}: its name must begin with {}", printable(map.atlas_file), prefix));
    return stem.substr(prefix.size());
}

/// Names become names of files, which must differ.
void check_names(const std::vector<std::string>& names, const std::string& heights)
{
    for (const std::string& name : names)
        if (std::ranges::count(names, name) > 1)
            throw InputError(fmt::format("companion {}: there are two of this name", printable(name)));
    if (heights.empty()) return;
    if (std::ranges::find(names, heights) == names.end())
        throw InputError(
            fmt::format("normals of {}: there is no such companion; {}", printable(heights),
                        names.empty() ? "the set has none" : fmt::format("there are: {}", fmt::join(names, ", "))));
    if (std::ranges::count(names, heights + "-normals") > 0)
        throw InputError(fmt::format("normals of {0}: there is a companion {0}-normals already", printable(heights)));
}

EngineMap companion(const std::filesystem::path& folder, const TextureSet& set, const CompanionMap& map, bool is_height)
{
    const std::filesystem::path file = folder / map.atlas_file;
    const RawPicture picture = read_raw_picture(file);
    const AtlasLayout layout = atlas_layout(set);
    if (picture.width != layout.columns * set.size || picture.height != layout.rows * set.size)
        throw InputError::at({file.string()},
                             fmt::format("{} x {} pixels: must be {} x {}", picture.width, picture.height,
                                         layout.columns * set.size, layout.rows * set.size));
    if (picture.channels.size() > 4)
        throw InputError::at({file.string()},
                             fmt::format("{} channels: textures have at most 4", picture.channels.size()));
    const bool is_color = map.is_original && !is_height && picture.type != SampleType::real;
    return decoded_map(companion_name(map), picture, is_color ? MapMeaning::colors : MapMeaning::numbers);
}

RawPicture picture_of(const PngPixels& pixels)
{
    static const std::vector<std::string> grey{"Y"}, colors{"R", "G", "B"};
    return {pixels.width, pixels.height, SampleType::byte, pixels.channels == 1 ? grey : colors, pixels.values};
}

}

EngineMap color_map(const TextureSet& set) { return decoded_map("", picture_of(atlas_of(set)), MapMeaning::colors); }

std::vector<EngineMap> engine_maps(const std::filesystem::path& folder, const TextureSet& set,
                                   const std::string& heights, double relief)
{
    std::vector<EngineMap> maps{color_map(set)};
    std::vector<std::string> names;
    for (const CompanionMap& map : set.companions) names.push_back(companion_name(map));
    check_names(names, heights);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const bool is_height = names[i] == heights;
        maps.push_back(companion(folder, set, set.companions[i], is_height));
        if (is_height) maps.push_back(height_normals(maps.back(), set, relief));
    }
    return maps;
}

int tile_levels(int size) { return std::countr_zero(static_cast<unsigned>(size)) + 1; }

EngineMap halved(const EngineMap& map)
{
    EngineMap half{map.name, map.meaning, map.type, map.width / 2, map.height / 2, map.channels, {}};
    const auto step = static_cast<std::size_t>(map.channels), row_values = static_cast<std::size_t>(map.width) * step;
    half.values.reserve(map.values.size() / 4);
    for (std::size_t row = 0; row < static_cast<std::size_t>(half.height); ++row)
        for (std::size_t column = 0; column < static_cast<std::size_t>(half.width); ++column)
            for (std::size_t c = 0; c < step; ++c) {
                const std::size_t at = 2 * row * row_values + 2 * column * step + c;
                half.values.push_back(((map.values[at] + map.values[at + step]) +
                                       (map.values[at + row_values] + map.values[at + row_values + step])) /
                                      4);
            }
    return half;
}

RawPicture encoded_level(const EngineMap& map)
{
    static const std::vector<std::string> grey{"Y", "A"}, colors{"R", "G", "B", "A"};
    const auto& names = map.channels < 3 ? grey : colors;
    RawPicture picture{map.width, map.height, map.type, {names.begin(), names.begin() + map.channels}, {}};
    picture.bytes.reserve(picture.at(0, map.height));
    const auto channels = static_cast<std::size_t>(map.channels);
    for (std::size_t first = 0; first < map.values.size(); first += channels) {
        double length = 1;
        if (map.meaning == MapMeaning::directions)
            length = std::sqrt(map.values[first] * map.values[first] + map.values[first + 1] * map.values[first + 1] +
                               map.values[first + 2] * map.values[first + 2]);
        for (std::size_t c = 0; c < channels; ++c) {
            const bool is_alpha = map.meaning == MapMeaning::colors && channels % 2 == 0 && c == channels - 1;
            append_encoded(picture.bytes, map.values[first + c] / length, map.type,
                           is_alpha ? MapMeaning::numbers : map.meaning);
        }
    }
    return picture;
}

}
