#include "base/densities/density.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

std::size_t channel_number(const LinearPicture& picture, std::string_view channel, const std::string& name)
{
    const auto found = std::ranges::find(picture.channels, channel);
    if (found == picture.channels.end())
        throw InputError(fmt::format("{}: \"{}\": must be light, ink or a channel of the picture: {}", name,
                                     printable(channel), fmt::join(picture.channels, ", ")));
    return static_cast<std::size_t>(found - picture.channels.begin());
}

/// Pixels by column and row from the top left, as programs for pictures name them.
std::string pixel_name(int column, int row) { return fmt::format("pixel ({}, {})", column, row); }

}

double luminance(const LinearPicture& picture, int column, int row)
{
    const std::size_t colors = picture.channels.size() - (picture.alpha ? 1 : 0);
    const auto channel = [&](std::size_t i) { return static_cast<double>(picture.at(column, row, i)); };
    return colors < 3 ? channel(0) : 0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2);
}

Density density_of_values(int width, int height, const std::vector<double>& values, const std::string& name)
{
    Density density{width, height, {}};
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto column = static_cast<int>(i % static_cast<std::size_t>(width));
        const auto row = height - 1 - static_cast<int>(i / static_cast<std::size_t>(width));
        if (!(values[i] >= 0) || std::isinf(values[i]))
            throw InputError(fmt::format("{}: {}: density {}: must be a number that is not negative", name,
                                         pixel_name(column, row), values[i]));
        largest = std::max(largest, values[i]);
    }
    if (largest == 0) throw InputError(fmt::format("{}: is 0 everywhere: must be positive somewhere", name));
    density.weights.reserve(values.size());
    for (const double value : values)
        density.weights.push_back(
            static_cast<std::uint64_t>(std::floor(value / largest * static_cast<double>(full_weight))));
    return density;
}

Density density_of_picture(const LinearPicture& picture, std::string_view channel, const std::string& name)
{
    const bool is_ink = channel == "ink", is_light = channel == "light";
    const std::size_t number = is_ink || is_light ? 0 : channel_number(picture, channel, name);
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (int row = picture.height; row-- > 0;)
        for (int column = 0; column < picture.width; ++column) {
            const double value = is_ink || is_light ? luminance(picture, column, row)
                                                    : static_cast<double>(picture.at(column, row, number));
            constexpr double rounding = 1e-6; // of the factors of luminance
            if (is_ink && value > 1 + rounding)
                throw InputError(fmt::format("{}: {}: luminance {}: must be at most 1 for ink", name,
                                             pixel_name(column, row), value));
            values.push_back(is_ink ? std::max(0.0, 1 - value) : value);
        }
    return density_of_values(picture.width, picture.height, values, name);
}

}
