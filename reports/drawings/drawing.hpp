// A drawing: polygons, disks, lines, text and images on a white ground, described once and written as SVG or PNG.
//
// A drawing as SVG and as PNG.
#pragma once

#include "base/images/png_file.hpp"
#include "reports/images/picture_store.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

using DrawingPoint = std::array<double, 2>; ///< x to the right, y downwards, in units of the drawing

/// The corners of a closed polygon without self-intersections.
using Polygon = std::vector<DrawingPoint>;

struct Disk
{
    DrawingPoint middle{};
    double radius = 0;
};

/// An open line, with a stroke only.
struct Line
{
    std::vector<DrawingPoint> points;
};

/// Words in DejaVu Sans, with a fill only.
struct Text
{
    DrawingPoint start{};    ///< on the line that the letters stand on
    double size = 1;         ///< of the font; a small x is a bit more than half as high
    std::string words;       ///< without < and &
    bool is_centred = false; ///< around `start`
};

/// Pixels as they are, without fill and stroke. In PNG files only.
struct Image
{
    DrawingPoint corner{}; ///< the upper left one
    double width = 1;      ///< pixels are square
    PngPixels pixels;      ///< of one or three channels
};

using Form = std::variant<Polygon, Disk, Line, Text, Image>;

struct Shape
{
    Shape(Form its_form, std::string its_fill, std::string its_stroke, double its_stroke_width = 0);

    Form form;
    std::string fill;        ///< "#rrggbb", or empty: not filled
    std::string stroke;      ///< the same, centred on the outline, with round corners and ends
    double stroke_width = 0; ///< in units of the drawing
};

/// Shapes between (0, 0) at the upper left and (width, height). Later shapes lie over earlier ones.
struct Drawing
{
    double width = 1;
    double height = 1;
    std::vector<Shape> shapes;
    bool keeps_tones = false;      ///< PNG files mix light, not bytes, so that a screen shows as much ink as there is
    double millimetres_a_unit = 0; ///< SVG documents have this size on paper, and no ground; 0: any size
};

/// The longest side of a PNG in pixels.
constexpr int max_drawing_pixels = 32'768;

/// An SVG document that scales. Coordinates are rounded to 0.01 units, so that a unit should be about a pixel.
/// Consecutive shapes become one path where that looks the same: they have the same fill without a stroke, or the same
/// stroke without a fill. Polygons with a fill only reach half a pixel beyond their outlines, at any scale: neighbours
/// that only touch would have a light seam between them. Throws std::logic_error for images, for colours that are not
/// "#rrggbb", and for sizes and coordinates that are not finite.
std::string drawing_svg(const Drawing& drawing);

/// A PNG whose bytes depend on the drawing and its size only: grey if all its colours are, else RGB. Pixels are square;
/// the last row may reach beyond the drawing and is white there. With polygons, and
/// where tones are kept, pixels are the mean of 4 x 4 samples, each of the colour of the last shape there, so that
/// polygons with an edge in common have no seam. Memory grows with
/// the width, not with the height. Throws InputError for fewer than 1 or more than max_drawing_pixels pixels on a side,
/// StorageError, and std::logic_error for colours, sizes and coordinates as above.
void write_drawing_png(const std::filesystem::path& path, const Drawing& drawing, int pixels_wide);

/// The red, green and blue of "#rrggbb". Throws std::logic_error for anything else.
std::array<int, 3> color_channels(const std::string& color);

/// A colour between two, channel by channel: `share` 0 is the first, 1 the second.
std::string mixed_color(const std::string& first, const std::string& second, double share);

/// The points that say where a shape is: corners, middle, start.
std::vector<DrawingPoint> points_of(const Shape& shape);

/// The reach of a shape beyond its points to any side.
double reach_of(const Shape& shape);

/// Throws std::logic_error for what no writer can draw.
void check_drawing(const Drawing& drawing);

/// Writes stem.svg and stem.png, so many pixels wide (max_drawing_pixels at most); the PNG only where the SVG is
/// another one than that which it was drawn with. Returns the SVG.
std::string write_drawing(const std::filesystem::path& stem, const Drawing& drawing, double pixels_wide,
                          PictureStore& store);

}
