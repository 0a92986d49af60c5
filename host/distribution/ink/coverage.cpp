#include "host/distribution/ink/coverage.hpp"

#include "base/images/srgb_light.hpp"
#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace poissonlab {
namespace {

using Corner = std::array<double, 2>;
using Stroke = std::array<double, 5>;

double dot(const Corner& a, const Corner& b) { return a[0] * b[0] + a[1] * b[1]; }
double cross(const Corner& a, const Corner& b) { return a[0] * b[1] - a[1] * b[0]; }

/// The points a + (b - a) part.
Corner between(const Corner& a, const Corner& b, double part)
{
    return {a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part};
}

/// The part of a polygon where dot(normal, p) <= limit.
ConvexPolygon clipped(const ConvexPolygon& polygon, const Corner& normal, double limit)
{
    ConvexPolygon part;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Corner &a = polygon.corners[i], &b = polygon.corners[(i + 1) % polygon.count];
        const double at_a = dot(normal, a) - limit, at_b = dot(normal, b) - limit;
        if (at_a <= 0) part.add(a);
        if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) part.add(between(a, b, at_a / (at_a - at_b)));
    }
    return part;
}

double polygon_area(const ConvexPolygon& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.count; ++i)
        twice += cross(polygon.corners[i], polygon.corners[(i + 1) % polygon.count]);
    return twice / 2;
}

double sector(double radius, const Corner& a, const Corner& b)
{
    return radius * radius / 2 * std::atan2(cross(a, b), dot(a, b));
}

/// The signed area that a disk has in common with the triangle of its centre and an edge.
double disk_in_triangle(double radius, const Corner& a, const Corner& b)
{
    const Corner edge{b[0] - a[0], b[1] - a[1]};
    const double squared = dot(edge, edge), along = dot(a, edge), beyond = dot(a, a) - radius * radius;
    const double root = along * along - squared * beyond;
    if (squared == 0) return 0;
    if (root <= 0) return sector(radius, a, b);
    const double in = (-along - std::sqrt(root)) / squared, out = (-along + std::sqrt(root)) / squared;
    if (out <= 0 || in >= 1) return sector(radius, a, b);
    const Corner p = in > 0 ? between(a, b, in) : a, q = out < 1 ? between(a, b, out) : b;
    double area = cross(p, q) / 2;
    if (in > 0) area += sector(radius, a, p);
    if (out < 1) area += sector(radius, q, b);
    return area;
}

ConvexPolygon moved(ConvexPolygon polygon, const Corner& by)
{
    for (std::size_t i = 0; i < polygon.count; ++i)
        polygon.corners[i] = {polygon.corners[i][0] + by[0], polygon.corners[i][1] + by[1]};
    return polygon;
}

double stroke_length(const Stroke& stroke) { return std::hypot(stroke[2] - stroke[0], stroke[3] - stroke[1]); }

/// Tells whether a place is in a stroke.
bool holds(const Stroke& stroke, const Corner& place)
{
    const Corner axis{stroke[2] - stroke[0], stroke[3] - stroke[1]};
    const Corner from{place[0] - stroke[0], place[1] - stroke[1]};
    const double squared = dot(axis, axis);
    const double part = squared > 0 ? std::clamp(dot(from, axis) / squared, 0.0, 1.0) : 0;
    const Corner away{from[0] - axis[0] * part, from[1] - axis[1] * part};
    return dot(away, away) < stroke[4] * stroke[4] / 4;
}

/// The part of a pixel that several strokes cover twice or more, each time but the first, at 16 x 16 places.
double common_part(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> here, double x, double y)
{
    constexpr int side = 16;
    int twice = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const Corner place{x + (column + 0.5) / side, y + (row + 0.5) / side};
            const auto held = std::ranges::count_if(here, [&](std::uint32_t i) { return holds(strokes[i], place); });
            twice += static_cast<int>(std::max<std::ptrdiff_t>(0, held - 1));
        }
    return twice / static_cast<double>(side * side);
}

/// A stroke, or a part of it, in a pixel.
struct PixelMark
{
    std::uint32_t pixel = 0;
    std::uint32_t mark = 0;

    auto operator<=>(const PixelMark&) const = default;
};

/// Adds the areas of strokes to the pixels that they reach, and lists them there.
std::vector<PixelMark> add_areas(const std::vector<Stroke>& strokes, Coverage& coverage)
{
    std::vector<PixelMark> marks;
    const auto pixel = [](double place, int count) {
        return static_cast<int>(std::clamp(std::floor(place), -1.0, static_cast<double>(count)));
    };
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (i % 4096 == 0) stop_if_interrupted();
        const auto& [x0, y0, x1, y1, width] = strokes[i];
        const double reach = width / 2;
        const int left = std::max(0, pixel(std::min(x0, x1) - reach, coverage.width));
        const int right = std::min(coverage.width - 1, pixel(std::max(x0, x1) + reach, coverage.width));
        const int bottom = std::max(0, pixel(std::min(y0, y1) - reach, coverage.height));
        const int top = std::min(coverage.height - 1, pixel(std::max(y0, y1) + reach, coverage.height));
        for (int row = bottom; row <= top; ++row)
            for (int column = left; column <= right; ++column) {
                const double area = stroke_in_pixel(strokes[i], column, row);
                if (area <= 0) continue;
                const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(coverage.width) +
                                static_cast<std::size_t>(column);
                coverage.parts[at] += area;
                coverage.laid += area;
                marks.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(i)});
            }
    }
    return marks;
}

/// Takes off what strokes have in common.
void subtract_overlaps(const std::vector<Stroke>& strokes, std::vector<PixelMark> marks, Coverage& coverage)
{
    std::ranges::sort(marks);
    std::vector<std::uint32_t> here;
    for (std::size_t i = 0; i < marks.size();) {
        if (i % 65'536 == 0) stop_if_interrupted();
        const std::uint32_t at = marks[i].pixel;
        here.clear();
        for (; i < marks.size() && marks[i].pixel == at; ++i) here.push_back(marks[i].mark);
        if (here.size() < 2) continue;
        const std::uint32_t columns = static_cast<std::uint32_t>(coverage.width);
        coverage.parts[at] -= common_part(strokes, here, at % columns, at / columns);
    }
}

}

double disk_in_polygon(double radius, const ConvexPolygon& polygon)
{
    double area = 0;
    for (std::size_t i = 0; i < polygon.count; ++i)
        area += disk_in_triangle(radius, polygon.corners[i], polygon.corners[(i + 1) % polygon.count]);
    return std::max(0.0, area);
}

double stroke_in_pixel(const std::array<double, 5>& stroke, double x, double y)
{
    const double length = stroke_length(stroke), radius = stroke[4] / 2;
    const Corner middle{x + 0.5 - stroke[0], y + 0.5 - stroke[1]};
    const Corner along =
        length > 0 ? Corner{(stroke[2] - stroke[0]) / length, (stroke[3] - stroke[1]) / length} : Corner{1, 0};
    const Corner across{-along[1], along[0]};
    // Most pixels around a stroke are in it or out of it as a whole.
    constexpr double half_diagonal = 0.70710678118654757;
    const double at = dot(middle, along), off = std::abs(dot(middle, across));
    const double to_axis = std::hypot(std::max({0.0, -at, at - length}), off);
    if (to_axis >= radius + half_diagonal) return 0;
    if (to_axis + half_diagonal <= radius) return 1;
    ConvexPolygon pixel;
    for (const Corner& corner : {Corner{-0.5, -0.5}, Corner{0.5, -0.5}, Corner{0.5, 0.5}, Corner{-0.5, 0.5}})
        pixel.add({middle[0] + corner[0], middle[1] + corner[1]});
    if (length == 0) return disk_in_polygon(radius, pixel);
    const Corner backwards{-along[0], -along[1]}, other{-across[0], -across[1]};
    const double begin = disk_in_polygon(radius, clipped(pixel, along, 0));
    const double end =
        disk_in_polygon(radius, moved(clipped(pixel, backwards, -length), {-along[0] * length, -along[1] * length}));
    const ConvexPolygon between_ends = clipped(clipped(pixel, backwards, 0), along, length);
    return begin + end + polygon_area(clipped(clipped(between_ends, across, radius), other, radius));
}

std::uint8_t shown_byte(double part) { return byte_of_light(static_cast<float>(65535 * (1 - part))); }

double shown_part(std::uint8_t byte) { return 1 - static_cast<double>(light_of_bytes()[byte]) / 65535; }

Coverage coverage_of(const MarkGroup& marks, int width, int height, double scale)
{
    Coverage coverage{width, height,
                      std::vector<double>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)), 0, 0};
    std::vector<Stroke> strokes;
    for (const auto& [x, y, radius] : marks.disks)
        strokes.push_back({x * scale, y * scale, x * scale, y * scale, 2 * radius * scale});
    for (const Stroke& stroke : marks.strokes) {
        strokes.push_back(stroke);
        for (double& number : strokes.back()) number *= scale;
    }
    subtract_overlaps(strokes, add_areas(strokes, coverage), coverage);
    for (double& part : coverage.parts) part = std::clamp(part, 0.0, 1.0);
    coverage.covered = std::accumulate(coverage.parts.begin(), coverage.parts.end(), 0.0);
    return coverage;
}

}
