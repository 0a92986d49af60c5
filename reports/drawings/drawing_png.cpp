// Drawings as PNG: polygons are sampled in 4 x 4 places a pixel, a band of rows at a time.
//
// A sample takes the colour of the last polygon that it lies in, and pixels are the mean of their samples: so
// polygons that share an edge leave no seam, which blending one over the other would.
#include "reports/drawings/drawing.hpp"

#include "base/errors/errors.hpp"
#include "base/images/png_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace poissonlab {
namespace {

constexpr int samples = 4;        // a pixel in each direction
constexpr int band_rows = 16;     // of pixels
constexpr int corner_points = 16; // of a stroke's round corner

using Polygon = std::vector<DrawingPoint>;
using Rgb = std::array<std::uint8_t, 3>;

struct Crossing
{
    double x = 0;
    int turns = 0;
};

/// The samples of a few rows of pixels; coordinates are in samples, with sample (i, j) at (i + 1/2, j + 1/2).
class Band
{
public:
    Band(int columns, int first_row, int rows)
        : columns_(columns), first_(first_row), rows_(rows),
          samples_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), Rgb{255, 255, 255})
    {}

    /// Those samples inside of a polygon, on whose left border or upper border they may lie (non-zero rule).
    void paint(const Polygon& polygon, const Rgb& color)
    {
        if (polygon.empty()) return;
        const auto [top, bottom] = std::ranges::minmax(polygon, {}, [](const auto& p) { return p[1]; });
        for (int row = std::max(first_, first_center(top[1])); row < std::min(first_ + rows_, first_center(bottom[1]));
             ++row) {
            find_crossings(polygon, row + 0.5);
            int turns = 0;
            for (std::size_t i = 0; i + 1 < crossings_.size(); ++i) {
                turns += crossings_[i].turns;
                if (turns != 0) fill(row, crossings_[i].x, crossings_[i + 1].x, color);
            }
        }
    }

    /// The mean of a pixel's samples; `row` is counted from the band's first row of pixels.
    Rgb pixel(int column, int row) const
    {
        std::array<int, 3> sum{};
        for (int y = row * samples; y < (row + 1) * samples; ++y)
            for (int x = column * samples; x < (column + 1) * samples; ++x)
                for (std::size_t i = 0; i < 3; ++i) sum[i] += samples_[index(x, y)][i];
        constexpr int count = samples * samples;
        Rgb mean{};
        for (std::size_t i = 0; i < 3; ++i) mean[i] = static_cast<std::uint8_t>((sum[i] + count / 2) / count);
        return mean;
    }

private:
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    /// The first sample whose centre is at `coordinate` or beyond; far outside, any that is outside.
    static int first_center(double coordinate)
    {
        constexpr double far = 1e9;
        return static_cast<int>(std::ceil(std::clamp(coordinate, -far, far) - 0.5));
    }

    /// Where a polygon crosses a horizontal line, from left to right. An edge is always taken from its upper
    /// end, so that polygons on both sides of it agree to the last bit.
    void find_crossings(const Polygon& polygon, double y)
    {
        crossings_.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const DrawingPoint& a = polygon[i];
            const DrawingPoint& b = polygon[(i + 1) % polygon.size()];
            const bool down = a[1] < b[1];
            const DrawingPoint& upper = down ? a : b;
            const DrawingPoint& lower = down ? b : a;
            if (y < upper[1] || y >= lower[1]) continue;
            const double share = (y - upper[1]) / (lower[1] - upper[1]);
            crossings_.push_back({upper[0] + share * (lower[0] - upper[0]), down ? 1 : -1});
        }
        std::ranges::sort(crossings_, {}, &Crossing::x);
    }

    void fill(int row, double left, double right, const Rgb& color)
    {
        const int first = std::max(0, first_center(left)), end = std::min(columns_, first_center(right));
        if (first >= end) return;
        const auto start = samples_.begin() + static_cast<std::ptrdiff_t>(index(first, row - first_));
        std::fill(start, start + (end - first), color);
    }

    int columns_;
    int first_;
    int rows_;
    std::vector<Rgb> samples_;
    std::vector<Crossing> crossings_;
};

Rgb rgb(const std::string& color)
{
    const auto channels = color_channels(color);
    return {static_cast<std::uint8_t>(channels[0]), static_cast<std::uint8_t>(channels[1]),
            static_cast<std::uint8_t>(channels[2])};
}

/// A rectangle along each side and a round corner at each point.
void paint_stroke(Band& band, const Polygon& outline, double width, const Rgb& color)
{
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& [x0, y0] = outline[i];
        const auto& [x1, y1] = outline[(i + 1) % outline.size()];
        Polygon corner;
        for (int k = 0; k < corner_points; ++k) {
            const double angle = 2 * std::numbers::pi * k / corner_points;
            corner.push_back({x0 + width / 2 * std::cos(angle), y0 + width / 2 * std::sin(angle)});
        }
        band.paint(corner, color);
        const double length = std::hypot(x1 - x0, y1 - y0);
        if (length == 0) continue;
        const double dx = (y0 - y1) / length * width / 2, dy = (x1 - x0) / length * width / 2;
        band.paint({{x0 + dx, y0 + dy}, {x1 + dx, y1 + dy}, {x1 - dx, y1 - dy}, {x0 - dx, y0 - dy}}, color);
    }
}

/// A drawing in samples, with what it takes to skip shapes quickly.
class Painter
{
public:
    Painter(const Drawing& drawing, double scale) : drawing_(drawing), scale_(scale)
    {
        for (const Shape& shape : drawing.shapes) {
            double top = 1, bottom = 0; // nothing, unless there are points
            for (const auto& [x, y] : shape.outline) {
                top = &shape.outline.front()[1] == &y ? y : std::min(top, y);
                bottom = &shape.outline.front()[1] == &y ? y : std::max(bottom, y);
            }
            const double reach = shape.stroke.empty() ? 0 : shape.stroke_width / 2;
            extents_.push_back({(top - reach) * scale, (bottom + reach) * scale});
        }
    }

    void paint(Band& band, int first_row, int rows) const
    {
        for (std::size_t i = 0; i < extents_.size(); ++i) {
            if (extents_[i][1] < first_row || extents_[i][0] > first_row + rows) continue;
            const Shape& shape = drawing_.shapes[i];
            Polygon outline = shape.outline;
            for (auto& [x, y] : outline) {
                x *= scale_;
                y *= scale_;
            }
            if (!shape.fill.empty()) band.paint(outline, rgb(shape.fill));
            if (!shape.stroke.empty()) paint_stroke(band, outline, shape.stroke_width * scale_, rgb(shape.stroke));
        }
    }

private:
    const Drawing& drawing_;
    double scale_;
    std::vector<std::array<double, 2>> extents_; ///< rows of samples
};

}

void write_drawing_png(const std::filesystem::path& path, const Drawing& drawing, int pixels_wide)
{
    check_drawing(drawing);
    const double scale = pixels_wide / drawing.width;
    constexpr double rounding = 1e-9; // an exact fit is not a pixel more
    const double pixels_high = std::max(1.0, std::ceil(drawing.height * scale * (1 - rounding)));
    if (pixels_wide < 1 || pixels_wide > max_drawing_pixels || pixels_high > max_drawing_pixels)
        throw InputError(fmt::format("{}: a picture of {} x {} pixels: must be from 1 to {} each way", path.string(),
                                     pixels_wide, pixels_high, max_drawing_pixels));
    const int height = static_cast<int>(pixels_high);
    const Painter painter(drawing, scale * samples);
    PngLayout layout{pixels_wide, height, 3};
    layout.rows_at_once = band_rows;
    // Few colours: rows compress as they are.
    layout.compression = 3;
    layout.filters = false;
    std::vector<Rgb> pixels;
    write_png(path, layout, [&](int first, int rows) {
        Band band(pixels_wide * samples, first * samples, rows * samples);
        painter.paint(band, first * samples, rows * samples);
        pixels.clear();
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < pixels_wide; ++column) pixels.push_back(band.pixel(column, row));
        return pixels.front().data();
    });
}

}
