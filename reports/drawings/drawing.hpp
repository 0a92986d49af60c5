// A drawing: polygons on a white ground, described once and written as SVG or PNG.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

using DrawingPoint = std::array<double, 2>; ///< x to the right, y downwards

/// A closed polygon without self-intersections. Two points make a line: a polygon with a stroke only.
struct Shape
{
    std::vector<DrawingPoint> outline; ///< in units of the drawing
    std::string fill;                  ///< "#rrggbb", or empty: not filled
    std::string stroke;                ///< the same, centred on the outline, with round corners
    double stroke_width = 0;           ///< in units of the drawing
};

/// From (0, 0) at the upper left to (width, height). Later shapes lie over earlier ones.
struct Drawing
{
    double width = 1;
    double height = 1;
    std::vector<Shape> shapes;
};

/// The longest side of a PNG in pixels.
constexpr int max_drawing_pixels = 32'768;

/// An SVG document that scales. Coordinates are rounded to 0.01 units, so that a unit should be about a
/// pixel. Consecutive shapes become one path where that looks the same: the same fill without a stroke, or
/// the same stroke without a fill. Fills without a stroke reach half a pixel beyond their outlines,
/// at any scale: neighbours that only touch would have a light seam between them. Throws std::logic_error for
/// colours that are not "#rrggbb", and for sizes and coordinates that are not finite.
std::string drawing_svg(const Drawing& drawing);

/// An RGB PNG whose bytes depend on the drawing and its size only. Pixels are square, the mean of 4 x 4
/// samples; the last row may reach beyond the drawing and is white there. Memory grows with the width, not
/// with the height. Throws InputError for fewer than 1 or more than max_drawing_pixels pixels on a side,
/// StorageError, and std::logic_error as above.
void write_drawing_png(const std::filesystem::path& path, const Drawing& drawing, int pixels_wide);

/// The red, green and blue of "#rrggbb". Throws std::logic_error for anything else.
std::array<int, 3> color_channels(const std::string& color);

/// A colour between two, channel by channel: `share` 0 is the first, 1 the second.
std::string mixed_color(const std::string& first, const std::string& second, double share);

/// Throws std::logic_error for what neither writer can draw.
void check_drawing(const Drawing& drawing);

}
