#include "host/texture/exemplar.hpp"

#include "base/errors/errors.hpp"
#include "base/images/raw_picture.hpp"
#include "base/images/srgb_light.hpp"
#include "base/programs/memory_limit.hpp"
#include "tiles/texture/texture_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace poissonlab {
namespace {

/// The sRGB byte of an amount of light; the inverse of what reading made of a byte.
std::uint8_t srgb_byte(double light)
{
    return static_cast<std::uint8_t>(std::lround(255 * srgb_of_light(std::clamp(light, 0.0, 1.0))));
}

/// The channels that are shown: three colours, or the first one alone.
std::vector<std::size_t> shown_channels(const LinearPicture& picture)
{
    std::vector<std::size_t> channels;
    for (std::size_t i = 0; i < picture.channels.size(); ++i)
        if (i != picture.alpha) channels.push_back(i);
    channels.resize(channels.size() >= 3 ? 3 : std::min<std::size_t>(1, channels.size()));
    return channels;
}

/// The light that the shown channels of a picture have.
struct LightRange
{
    double brightest = 1; ///< at least 1
    double lowest = 0;    ///< at most 0
};

/// Throws InputError for numbers that are not finite.
LightRange light_range(const LinearPicture& picture, const std::vector<std::size_t>& channels, const std::string& file)
{
    LightRange range;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
            for (const std::size_t channel : channels) {
                const double light = picture.at(column, row, channel);
                if (!std::isfinite(light))
                    throw InputError(
                        fmt::format("{}: the pixel in column {}, row {} is not a finite number", file, column, row));
                range.brightest = std::max(range.brightest, light);
                range.lowest = std::min(range.lowest, light);
            }
    return range;
}

std::string light_note(const LightRange& range, const std::string& file)
{
    std::string words;
    if (range.brightest > 1) words = fmt::format("light up to {:.4g} is tone-mapped", range.brightest);
    if (range.lowest < 0)
        words +=
            fmt::format("{}negative numbers, down to {:.4g}, count as 0", words.empty() ? "" : " and ", range.lowest);
    return words.empty() ? "" : fmt::format("{}: {} where tiles are chosen and cut", printable(file), words);
}

/// Throws InputError if a side is too long, or if `copies` bytes for each number of the picture are more than the
/// memory that there is.
void check_room(const std::string& file, const PictureHeader& header, std::uint64_t copies)
{
    if (header.width > most_exemplar_pixels || header.height > most_exemplar_pixels)
        throw InputError(fmt::format("{}: {} x {} pixels: must have at most {} along a side", file, header.width,
                                     header.height, most_exemplar_pixels));
    const std::uint64_t bytes = copies * static_cast<std::uint64_t>(header.width) *
                                static_cast<std::uint64_t>(header.height) * static_cast<std::uint64_t>(header.channels);
    constexpr double gibibyte = 1 << 30;
    if (bytes > memory_limit())
        throw InputError(fmt::format("{}: {} x {} pixels need {:.1f} GiB of memory to be read: must be at most {:.1f}",
                                     file, header.width, header.height, static_cast<double>(bytes) / gibibyte,
                                     static_cast<double>(memory_limit()) / gibibyte));
}

bool is_alpha(const std::string& channel) { return channel == "A" || channel.ends_with(".A"); }

/// True for files whose numbers survive the conversion to light and back: 8 bits, grey or three colours, no alpha.
std::optional<PngPixels> opaque_bytes(const std::filesystem::path& file, const PictureHeader& header)
{
    if (header.type != SampleType::byte || (header.channels != 1 && header.channels != 3)) return {};
    check_room(file.string(), header, sizeof(std::uint8_t));
    RawPicture raw = read_raw_picture(file);
    if (std::ranges::any_of(raw.channels, is_alpha)) return {};
    return PngPixels{raw.width, raw.height, header.channels, std::move(raw.bytes)};
}

/// Adds the sentence about alpha that is left out to what was said of the file, or else to its name.
std::string alpha_note(const LinearPicture& picture, const std::string& name)
{
    std::size_t clear = 0;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) clear += cover_at(picture, column, row) < 1;
    if (clear == 0) return "";
    return fmt::format("{}alpha is left out: {} {} not opaque, and {} colour beneath counts",
                       name.empty() ? "; " : name + ": ", clear, clear == 1 ? "pixel is" : "pixels are",
                       clear == 1 ? "its" : "their");
}

}

double tone_mapped(double light, double brightest)
{
    return brightest <= 1 ? light : light * (1 + light / (brightest * brightest)) / (1 + light);
}

PngPixels read_exemplar(const std::filesystem::path& file, AlphaUse use)
{
    std::string note;
    return read_exemplar(file, note, use);
}

PngPixels read_exemplar(const std::filesystem::path& file, std::string& note, AlphaUse use)
{
    note.clear();
    const PictureHeader header = read_picture_header(file);
    if (std::optional<PngPixels> bytes = opaque_bytes(file, header)) return std::move(*bytes);
    check_room(file.string(), header, 3 * sizeof(float)); // as the file has them, upright, and the result
    const LinearPicture picture = read_linear_picture(file, use);
    const std::vector<std::size_t> channels = shown_channels(picture);
    if (channels.empty()) throw InputError(fmt::format("{}: has no channel but alpha", file.string()));
    const LightRange range = light_range(picture, channels, file.string());
    note = light_note(range, file.filename().string());
    if (use == AlphaUse::left_out) note += alpha_note(picture, note.empty() ? printable(file.filename().string()) : "");
    PngPixels exemplar{picture.width, picture.height, static_cast<int>(channels.size()), {}};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
            for (const std::size_t channel : channels) {
                const double light = std::max(0.0, static_cast<double>(picture.at(column, row, channel)));
                exemplar.values.push_back(srgb_byte(tone_mapped(light, range.brightest)));
            }
    return exemplar;
}

PngPixels side_by_side(const PngPixels& first, const PngPixels& second)
{
    if (first.channels != second.channels)
        throw InputError("the exemplar of marked corners must have colours as the other one has, or none");
    PngPixels both{first.width + second.width, std::min(first.height, second.height), first.channels, {}};
    for (int row = 0; row < both.height; ++row)
        for (const PngPixels* one : {&first, &second})
            both.values.insert(both.values.end(), one->values.begin() + static_cast<std::ptrdiff_t>(one->at(0, row, 0)),
                               one->values.begin() + static_cast<std::ptrdiff_t>(one->at(0, row + 1, 0)));
    return both;
}

}
