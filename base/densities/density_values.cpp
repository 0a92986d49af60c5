#include "base/densities/density_values.hpp"

#include "base/densities/density.hpp"
#include "base/files/file_kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace poissonlab {
namespace {

std::size_t channel_number(const LinearPicture& picture, std::string_view channel, const std::string& name)
{
    const auto found = std::ranges::find(picture.channels, channel);
    if (found == picture.channels.end())
        throw UnknownChannel(fmt::format("{}: \"{}\": must be light, ink or a channel of the picture: {}", name,
                                         printable(channel), fmt::join(picture.channels, ", ")));
    return static_cast<std::size_t>(found - picture.channels.begin());
}

}

std::string pixel_name(int width, int height, std::size_t index)
{
    const auto column = static_cast<int>(index % static_cast<std::size_t>(width));
    const auto row = static_cast<int>(index / static_cast<std::size_t>(width));
    return fmt::format("pixel ({}, {})", column, height - 1 - row);
}

double luminance(const LinearPicture& picture, int column, int row)
{
    const std::size_t colors = picture.channels.size() - (picture.alpha ? 1 : 0);
    const auto channel = [&](std::size_t i) { return static_cast<double>(picture.at(column, row, i)); };
    return colors < 3 ? channel(0) : 0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2);
}

std::string clamp_rounding(std::vector<double>& values, const std::string& name)
{
    constexpr double most_of_mean = 0.1, most_of_sum = 1e-3;
    double above = 0, below = 0, least = 0;
    std::size_t count = 0;
    for (const double value : values) {
        (value < 0 ? below : above) += value; // what is no number spoils the sum of those above
        least = std::min(least, value);
        count += value < 0 ? 1 : 0;
    }
    const double mean = (above + below) / static_cast<double>(values.size());
    if (count == 0 || !(least >= -most_of_mean * mean && below >= -most_of_sum * above)) return {};
    for (double& value : values) value = value < 0 ? 0 : value;
    return fmt::format("{}: {} pixel{} below 0, by up to {:.2g} of the mean, {} taken as 0: rounding of the file", name,
                       count, count == 1 ? "" : "s", -least / mean, count == 1 ? "is" : "are");
}

PixelValues picture_values(const LinearPicture& picture, std::string_view channel, const std::string& name)
{
    const bool is_ink = channel == "ink", is_light = channel == "light";
    const std::size_t number = is_ink || is_light ? 0 : channel_number(picture, channel, name);
    PixelValues values{picture.width, picture.height, {}};
    values.values.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int row = picture.height; row-- > 0;)
        for (int column = 0; column < picture.width; ++column) {
            double value = is_ink || is_light ? luminance(picture, column, row)
                                              : static_cast<double>(picture.at(column, row, number));
            if (is_ink) value += 1 - static_cast<double>(cover_at(picture, column, row)); // paper is white
            constexpr double rounding = 1e-6;                                             // of the factors of luminance
            if (is_ink && value > 1 + rounding)
                throw InputError(fmt::format("{}: {}: luminance {}: must be at most 1 for ink", name,
                                             pixel_name(picture.width, picture.height, values.values.size()), value));
            values.values.push_back(value);
        }
    if (!is_ink) return values;
    values.note = clamp_rounding(values.values, name);
    for (double& value : values.values) value = std::max(1 - value, 0.0); // of what is no number: itself
    return values;
}

PixelValues middle_of(PixelValues values, double zoom)
{
    if (zoom == 1) return values;
    PixelValues part{std::max(1, static_cast<int>(std::lround(values.width / zoom))),
                     std::max(1, static_cast<int>(std::lround(values.height / zoom))),
                     {},
                     values.note};
    const int left = (values.width - part.width) / 2, bottom = (values.height - part.height) / 2;
    for (int row = 0; row < part.height; ++row)
        for (int column = 0; column < part.width; ++column)
            part.values.push_back(values.at(left + column, bottom + row));
    return part;
}

InputError formula_error(const std::string& text, const InputError& error)
{
    std::error_code unknown;
    const bool is_name = text.find_first_of("./") != std::string::npos || std::filesystem::exists(text, unknown);
    if (!is_name) return error;
    return InputError(fmt::format("{}: {}; as a {}", printable(text), lack_of_file(text), error.what()));
}

PixelValues values_of_text(const std::string& text, const std::string& from, double width, double height)
{
    if (is_file_name(text)) return picture_values(read_linear_picture(text), from, text);
    try {
        return formula_values(text, width, height);
    } catch (const InputError& error) {
        throw formula_error(text, error);
    }
}

}
