#include "reports/drawings/drawing.hpp"

#include "base/files/whole_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace poissonlab {
namespace {

template <class... Functions>
struct Overloaded : Functions...
{
    using Functions::operator()...;
};

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

Shape::Shape(Form its_form, std::string its_fill, std::string its_stroke, double its_stroke_width)
    : form(std::move(its_form)), fill(std::move(its_fill)), stroke(std::move(its_stroke)),
      stroke_width(its_stroke_width)
{}

std::vector<DrawingPoint> points_of(const Shape& shape)
{
    return std::visit(Overloaded{
                          [](const Polygon& corners) { return corners; },
                          [](const Line& line) { return line.points; },
                          [](const Disk& disk) { return Polygon{disk.middle}; },
                          [](const Text& text) { return Polygon{text.start}; },
                          [](const Image& image) {
                              const double height = image.width * image.pixels.height / image.pixels.width;
                              return Polygon{image.corner, {image.corner[0] + image.width, image.corner[1] + height}};
                          },
                      },
                      shape.form);
}

double reach_of(const Shape& shape)
{
    const double stroke = shape.stroke.empty() ? 0 : shape.stroke_width / 2;
    if (const auto* disk = std::get_if<Disk>(&shape.form)) return disk->radius + stroke;
    if (const auto* text = std::get_if<Text>(&shape.form)) return text->size * static_cast<double>(text->words.size());
    return stroke;
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
        if (!(reach_of(shape) >= 0 && is_drawable(reach_of(shape))))
            throw std::logic_error(fmt::format("a disk or letters of size {}", reach_of(shape)));
        for (const auto& [x, y] : points_of(shape))
            if (!is_drawable(x) || !is_drawable(y))
                throw std::logic_error(fmt::format("a point of a drawing at ({}, {})", x, y));
    }
}

std::string write_drawing(const std::filesystem::path& stem, const Drawing& drawing, double pixels_wide,
                          PictureStore& store)
{
    const std::filesystem::path png = stem.string() + ".png";
    const auto svg = drawing_svg(drawing);
    const auto wide = static_cast<int>(std::ceil(std::min<double>(pixels_wide, max_drawing_pixels)));
    write_whole_file(stem.string() + ".svg", svg);
    store.draw_once({png}, svg + std::to_string(wide), [&] { write_drawing_png(png, drawing, wide); });
    return svg;
}

}
