// Triangles fill a buffer of depths, row by row; dots are drawn where they are in front. Pixels are means of 2 x 2.

#include "host/distribution/surfaces/surface_view.hpp"

#include "base/surfaces/triangle_mesh.hpp"
#include "results/pictures/curve_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace poissonlab {
namespace {

/// Samples of a pixel along each axis.
constexpr int view_samples = 2;

/// The part of a view that the surface may fill.
constexpr double filled_part = 0.94;

/// A direction to look along: to the right, up, and towards the viewer.
struct Camera
{
    MeshPoint right, up, back;
};

/// Turned about z, and then seen from above by an angle.
Camera camera_at(double turn, double height)
{
    const double c = std::cos(turn), s = std::sin(turn), ch = std::cos(height), sh = std::sin(height);
    return {{c, s, 0}, {-s * sh, c * sh, ch}, {s * ch, -c * ch, sh}};
}

/// One view as samples, rows from the top.
class SurfaceCanvas
{
public:
    SurfaceCanvas(const FixedSurface& surface, const Camera& camera, int side)
        : surface_(surface), camera_(camera), side_(side), depth_(samples(), -INFINITY), grey_(samples(), 255.0F),
          dots_(samples())
    {
        MeshPoint low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
        for (const SurfaceTriangle& t : surface.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const MeshPoint p = turned(place(t, i));
                for (std::size_t k = 0; k < 3; ++k) {
                    low[k] = std::min(low[k], p[k]);
                    high[k] = std::max(high[k], p[k]);
                }
            }
        scale_ = filled_part * side / std::max({high[0] - low[0], high[1] - low[1], 1.0});
        middle_ = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0};
        needed_ = scale_ * (high[1] - low[1]) + (1 - filled_part) * side;
    }

    void draw_triangles()
    {
        for (const SurfaceTriangle& t : surface_.triangles) {
            const double light = std::abs(dot(camera_.back, normal_of(t)));
            fill({on_canvas(place(t, 0)), on_canvas(place(t, 1)), on_canvas(place(t, 2))},
                 static_cast<float>(170 + 70 * light));
        }
    }

    /// Dots of a radius in samples. Those of closed surfaces are on the outside only.
    void draw_dots(const std::vector<SurfacePoint>& points, double radius, const SurfaceDots& dots)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (!dots.is_closed || dot(camera_.back, normal_of(surface_.triangles[points[i].triangle])) > 0)
                draw_dot(points[i], radius, dots.classes.empty() ? 0 : dots.classes[i]);
    }

    double scale() const { return scale_; }
    double needed_rows() const { return needed_; } ///< around the middle one
    float grey(int column, int row) const { return grey_[at(column, row)]; }

    /// The class of the dot there, counted from 1; 0: there is none.
    std::uint32_t dot_at(int column, int row) const { return dots_[at(column, row)]; }

private:
    std::size_t samples() const { return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_); }
    std::size_t at(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(column);
    }

    static MeshPoint place(const SurfaceTriangle& t, std::size_t corner)
    {
        return {double(t.corners[3 * corner]), double(t.corners[3 * corner + 1]), double(t.corners[3 * corner + 2])};
    }

    MeshPoint turned(const MeshPoint& p) const
    {
        return {dot(camera_.right, p), dot(camera_.up, p), dot(camera_.back, p)};
    }

    /// Columns, rows from the top, and depths, all in samples.
    MeshPoint on_canvas(const MeshPoint& p) const
    {
        const MeshPoint t = turned(p);
        return {side_ / 2.0 + scale_ * (t[0] - middle_[0]), side_ / 2.0 - scale_ * (t[1] - middle_[1]), scale_ * t[2]};
    }

    void fill(const std::array<MeshPoint, 3>& c, float grey)
    {
        const double twice_area = (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[2][0] - c[0][0]) * (c[1][1] - c[0][1]);
        if (twice_area == 0) return;
        const auto [x_low, x_high] = std::minmax({c[0][0], c[1][0], c[2][0]});
        const auto [y_low, y_high] = std::minmax({c[0][1], c[1][1], c[2][1]});
        for (int row = std::max(0, int(y_low)); row <= std::min(side_ - 1, int(y_high)); ++row)
            for (int column = std::max(0, int(x_low)); column <= std::min(side_ - 1, int(x_high)); ++column) {
                const double x = column + 0.5, y = row + 0.5;
                const double a = ((c[1][0] - x) * (c[2][1] - y) - (c[2][0] - x) * (c[1][1] - y)) / twice_area;
                const double b = ((c[2][0] - x) * (c[0][1] - y) - (c[0][0] - x) * (c[2][1] - y)) / twice_area;
                if (a < 0 || b < 0 || a + b > 1) continue;
                const double depth = a * c[0][2] + b * c[1][2] + (1 - a - b) * c[2][2];
                if (depth <= depth_[at(column, row)]) continue;
                depth_[at(column, row)] = static_cast<float>(depth);
                grey_[at(column, row)] = grey;
            }
    }

    /// A disk in the plane of the point's triangle.
    void draw_dot(const SurfacePoint& point, double radius, std::uint32_t own)
    {
        const MeshPoint normal = turned(normal_of(surface_.triangles[point.triangle]));
        const double facing = std::max(0.05, std::abs(normal[2])), sign = normal[2] < 0 ? -1 : 1;
        const MeshPoint c = on_canvas({double(point.place[0]), double(point.place[1]), double(point.place[2])});
        const auto ends = [&](double middle) {
            return std::pair{std::max(0, int(middle - radius)), std::min(side_ - 1, int(middle + radius))};
        };
        for (int row = ends(c[1]).first; row <= ends(c[1]).second; ++row)
            for (int column = ends(c[0]).first; column <= ends(c[0]).second; ++column) {
                const double right = column + 0.5 - c[0], up = c[1] - row - 0.5;
                const double back = -sign * (normal[0] * right + normal[1] * up) / facing;
                // A pixel's depth is that of its middle, and neighbouring triangles have other slopes.
                if (right * right + up * up + back * back <= radius * radius &&
                    c[2] + back + radius / 4 + 1 / facing >= depth_[at(column, row)]) {
                    grey_[at(column, row)] = 0;
                    dots_[at(column, row)] = own + 1;
                }
            }
    }

    const FixedSurface& surface_;
    Camera camera_;
    int side_;
    double scale_ = 1, needed_ = 0;
    MeshPoint middle_{};
    std::vector<float> depth_, grey_;
    std::vector<std::uint32_t> dots_; ///< see dot_at()
};

SurfaceCanvas drawn(const FixedSurface& surface, const std::vector<SurfacePoint>& points, const SurfaceDots& dots,
                    const Camera& camera, int side)
{
    SurfaceCanvas canvas(surface, camera, side);
    canvas.draw_triangles();
    const double radius = dots.distance / surface.unit * canvas.scale() / 6;
    canvas.draw_dots(points, std::clamp(radius, 0.8, side / 60.0), dots);
    return canvas;
}

/// The colour of each class that has points, from 0 to 255.
std::vector<std::array<float, 3>> colors_of(const SurfaceDots& dots)
{
    std::vector<std::array<float, 3>> colors;
    for (const std::uint32_t own : dots.classes)
        for (std::size_t i = colors.size(); i <= own; ++i) colors.push_back(color_of_class(i));
    return colors;
}

}

std::array<float, 3> color_of_class(std::size_t own)
{
    std::array<float, 3> color{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        color[channel] = static_cast<float>(std::stoi(class_color(own).substr(1 + 2 * channel, 2), nullptr, 16));
    return color;
}

PngPixels surface_view(const FixedSurface& surface, const std::vector<SurfacePoint>& points, const SurfaceDots& dots,
                       int pixels)
{
    const int side = std::max(1, pixels / 2);
    std::vector<SurfaceCanvas> canvases;
    double needed = 1;
    for (const Camera& camera : {camera_at(-0.5, 0.5), camera_at(2.64, 0.5)}) {
        canvases.push_back(drawn(surface, points, dots, camera, side * view_samples));
        needed = std::max(needed, canvases.back().needed_rows() / view_samples);
    }
    const int height = std::min(side, static_cast<int>(std::ceil(needed))), top = (side - height) / 2;
    const std::vector<std::array<float, 3>> colors = colors_of(dots);
    PngPixels view{2 * side, height, dots.classes.empty() ? 1 : 3, {}};
    view.values.resize(view.at(0, height, 0));
    for (int number = 0; number < 2; ++number)
        for (int row = 0; row < height; ++row)
            for (int column = 0; column < side; ++column)
                for (int channel = 0; channel < view.channels; ++channel) {
                    const SurfaceCanvas& canvas = canvases[static_cast<std::size_t>(number)];
                    float sum = 0;
                    for (int i = 0; i < view_samples * view_samples; ++i) {
                        const int x = view_samples * column + i % view_samples;
                        const int y = view_samples * (row + top) + i / view_samples;
                        const std::uint32_t own = colors.empty() ? 0 : canvas.dot_at(x, y);
                        sum += own > 0 ? colors[own - 1][static_cast<std::size_t>(channel)] : canvas.grey(x, y);
                    }
                    view.values[view.at(number * side + column, row, channel)] =
                        static_cast<std::uint8_t>(std::lround(sum / (view_samples * view_samples)));
                }
    return view;
}

}
