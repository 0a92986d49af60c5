#include "reports/drawings/drawing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr double largest_coordinate = 1e9; // hundredths of units are exact far beyond

bool is_drawable(double coordinate) { return std::abs(coordinate) <= largest_coordinate; }

int hexadecimal_digit(char digit)
{
    if (digit >= '0' && digit <= '9') return digit - '0';
    if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
    return -1;
}

}

std::array<int, 3> color_channels(const std::string& color)
{
    std::array<int, 3> channels{};
    bool valid = color.size() == 7 && color.front() == '#';
    for (std::size_t i = 0; valid && i < 3; ++i) {
        const int high = hexadecimal_digit(color[2 * i + 1]);
        const int low = hexadecimal_digit(color[2 * i + 2]);
        valid = high >= 0 && low >= 0;
        channels[i] = 16 * high + low;
    }
    if (!valid) throw std::logic_error("not a colour of the form #rrggbb: '" + color + "'");
    return channels;
}

std::string mixed_color(const std::string& first, const std::string& second, double share)
{
    const auto from = color_channels(first);
    const auto to = color_channels(second);
    std::string color = "#";
    for (std::size_t i = 0; i < 3; ++i)
        color += fmt::format("{:02x}", std::lround(from[i] + share * (to[i] - from[i])));
    return color;
}

void check_drawing(const Drawing& drawing)
{
    if (!(drawing.width > 0 && drawing.height > 0 && is_drawable(drawing.width) && is_drawable(drawing.height)))
        throw std::logic_error(fmt::format("a drawing of {} x {}", drawing.width, drawing.height));
    for (const Shape& shape : drawing.shapes) {
        if (!shape.fill.empty()) color_channels(shape.fill);
        if (!shape.stroke.empty()) color_channels(shape.stroke);
        if (!(shape.stroke_width >= 0 && is_drawable(shape.stroke_width)))
            throw std::logic_error(fmt::format("a stroke of width {}", shape.stroke_width));
        for (const auto& [x, y] : shape.outline)
            if (!is_drawable(x) || !is_drawable(y))
                throw std::logic_error(fmt::format("a point of a drawing at ({}, {})", x, y));
    }
}

}
