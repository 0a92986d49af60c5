// This draws textured quads in the sun, by buffers of depths: one from the eye, one from the sun for shadows. Both look
// along parallel lines. Pixels are means of 3 x 3 samples in linear light.
#include "base/images/srgb_light.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "host/distribution/surface_textures/quad_atlas.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr int view_samples = 3;
constexpr std::uint32_t no_quad = UINT32_MAX;

MeshPoint sum_of(const MeshPoint& a, double share, const MeshPoint& b)
{
    return {a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]};
}

/// Directions to the right, up, and towards the eye, which is turned about z and raised by an angle.
struct EyeAxes
{
    MeshPoint right, up, back;

    EyeAxes(double turn, double height)
        : right{std::cos(turn), std::sin(turn), 0}, up{-std::sin(turn) * std::sin(height),
                                                       std::cos(turn) * std::sin(height), std::cos(height)},
          back{std::sin(turn) * std::cos(height), -std::cos(turn) * std::cos(height), std::sin(height)}
    {}
};

/// Finds what each sample shows: the nearest quad, and the place on it.
class SeenQuads
{
public:
    struct Seen
    {
        std::uint32_t quad = no_quad;
        float u = 0, v = 0, depth = -INFINITY;
    };

    SeenQuads(const QuadMesh& mesh, const EyeAxes& axes, int width, int height, double filled)
        : axes_(axes), width_(width), height_(height),
          seen_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    {
        MeshPoint low{INFINITY, INFINITY, 0}, high{-INFINITY, -INFINITY, 0};
        for (const MeshPoint& p : mesh.vertices)
            for (std::size_t k = 0; k < 2; ++k) {
                const double at = dot(p, k == 0 ? axes.right : axes.up);
                low[k] = std::min(low[k], at);
                high[k] = std::max(high[k], at);
            }
        scale_ =
            filled * std::min(width / std::max(high[0] - low[0], 1e-300), height / std::max(high[1] - low[1], 1e-300));
        middle_ = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0};
        for (std::uint32_t q = 0; q < mesh.quads.size(); ++q) draw(mesh, q);
    }

    /// Returns a place in samples from the upper left corner, and towards the eye.
    MeshPoint at(const MeshPoint& p) const
    {
        return {width_ / 2.0 + (dot(p, axes_.right) - middle_[0]) * scale_,
                height_ / 2.0 - (dot(p, axes_.up) - middle_[1]) * scale_, dot(p, axes_.back) * scale_};
    }
    /// Returns the place of the level plane at a height that a sample shows.
    MeshPoint on_plane(double x, double y, double height) const
    {
        const double right = (x - width_ / 2.0) / scale_ + middle_[0], up = (height_ / 2.0 - y) / scale_ + middle_[1];
        const MeshPoint p = sum_of(sum_of({}, right, axes_.right), up, axes_.up);
        return sum_of(p, (height - p[2]) / axes_.back[2], axes_.back);
    }
    const Seen& seen(int x, int y) const
    {
        return seen_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
    }

    /// Returns the share of nine samples around a place that nothing nearer to the eye hides.
    double share_in_sight(const MeshPoint& place) const
    {
        const MeshPoint p = at(place);
        int free = 0;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j) {
                const int x = static_cast<int>(std::floor(p[0])) + i, y = static_cast<int>(std::floor(p[1])) + j;
                free += x < 0 || y < 0 || x >= width_ || y >= height_ || seen(x, y).depth <= p[2] + 4;
            }
        return free / 9.0;
    }

    const EyeAxes& axes() const { return axes_; }
    double scale() const { return scale_; }

private:
    void draw(const QuadMesh& mesh, std::uint32_t q)
    {
        constexpr std::array<std::array<double, 2>, 4> unit_square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        const MeshPoint middle = at(middle_of(mesh, q));
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t next = (k + 1) % 4;
            const std::array<MeshPoint, 3> c{at(mesh.vertices[mesh.quads[q][k]]),
                                             at(mesh.vertices[mesh.quads[q][next]]), middle};
            const double area = (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[2][0] - c[0][0]) * (c[1][1] - c[0][1]);
            if (area == 0) continue;
            const auto ends = [&](std::size_t axis, int most) {
                const auto [low, high] = std::minmax({c[0][axis], c[1][axis], c[2][axis]});
                return std::pair{std::max(0, static_cast<int>(low)), std::min(most - 1, static_cast<int>(high))};
            };
            for (int y = ends(1, height_).first; y <= ends(1, height_).second; ++y)
                for (int x = ends(0, width_).first; x <= ends(0, width_).second; ++x) {
                    const double px = x + 0.5, py = y + 0.5;
                    const double a = ((c[1][0] - px) * (c[2][1] - py) - (c[2][0] - px) * (c[1][1] - py)) / area;
                    const double b = ((c[2][0] - px) * (c[0][1] - py) - (c[0][0] - px) * (c[2][1] - py)) / area;
                    const double m = 1 - a - b;
                    if (a < 0 || b < 0 || m < 0) continue;
                    const auto depth = static_cast<float>(a * c[0][2] + b * c[1][2] + m * c[2][2]);
                    Seen& sample = seen_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                         static_cast<std::size_t>(x)];
                    if (depth <= sample.depth) continue;
                    sample = {q, static_cast<float>(a * unit_square[k][0] + b * unit_square[next][0] + m / 2),
                              static_cast<float>(a * unit_square[k][1] + b * unit_square[next][1] + m / 2), depth};
                }
        }
    }

    EyeAxes axes_;
    int width_, height_;
    double scale_ = 1;
    MeshPoint middle_{};
    std::vector<Seen> seen_;
};

/// Interpolates a picture bilinearly at a place in pixels; `of` turns bytes into numbers.
template <class Of>
MeshPoint sampled(const PngPixels& picture, const std::array<double, 2>& at, const Of& of)
{
    const int x = static_cast<int>(std::floor(at[0] - 0.5)), y = static_cast<int>(std::floor(at[1] - 0.5));
    const double right = at[0] - 0.5 - x, down = at[1] - 0.5 - y;
    MeshPoint sum{};
    for (int i = 0; i < 4; ++i) {
        const double share = (i % 2 == 1 ? right : 1 - right) * (i / 2 == 1 ? down : 1 - down);
        const int column = std::clamp(x + i % 2, 0, picture.width - 1),
                  row = std::clamp(y + i / 2, 0, picture.height - 1);
        for (int c = 0; c < 3; ++c)
            sum[static_cast<std::size_t>(c)] +=
                share * of(picture.values[picture.at(column, row, std::min(c, picture.channels - 1))]);
    }
    return sum;
}

class QuadPainter
{
public:
    QuadPainter(const QuadMesh& mesh, const QuadTopology& topology, const QuadAtlas& atlas)
        : mesh_(mesh), atlas_(atlas), normals_(corner_normals(mesh, topology))
    {
        for (const MeshPoint& p : mesh.vertices) ground_ = std::min(ground_, p[2]);
    }

    void paint(PngPixels& picture, int left, int side, double turn) const
    {
        const SeenQuads eye(mesh_, {turn, 0.5}, side * view_samples, side * view_samples, 0.8);
        const SeenQuads sun(mesh_, {turn - 0.75, 0.85}, side * view_samples, side * view_samples, 0.98);
        const auto& light = light_of_bytes();
        tbb::parallel_for(0, side, [&](int row) {
            for (int column = 0; column < side; ++column) {
                MeshPoint sum{};
                for (int i = 0; i < view_samples * view_samples; ++i)
                    sum = sum_of(sum, 1.0 / (view_samples * view_samples),
                                 color_at(eye, sun, view_samples * column + i % view_samples,
                                          view_samples * row + i / view_samples, light));
                for (int c = 0; c < 3; ++c)
                    picture.values[picture.at(left + column, row, c)] =
                        byte_of_light(static_cast<float>(std::min(65535.0, sum[static_cast<std::size_t>(c)])));
            }
        });
    }

private:
    template <class Light>
    MeshPoint color_at(const SeenQuads& eye, const SeenQuads& sun, int x, int y, const Light& light) const
    {
        const auto& seen = eye.seen(x, y);
        if (seen.quad == no_quad) {
            const double lit = sun.share_in_sight(eye.on_plane(x + 0.5, y + 0.5, ground_));
            return lit_by({44000, 43500, 42500}, {0, 0, 1}, sun.axes().back, lit);
        }
        const auto at = atlas_.place_of(seen.quad, seen.u, seen.v);
        const MeshPoint color = sampled(atlas_.color, at, [&](std::uint8_t byte) { return double{light[byte]}; });
        const MeshPoint place = place_on(mesh_, seen.quad, seen.u, seen.v);
        return lit_by(color, normal_at(seen, at), sun.axes().back, sun.share_in_sight(place));
    }

    static MeshPoint lit_by(const MeshPoint& color, const MeshPoint& normal, const MeshPoint& sun, double share)
    {
        const double sky = 0.3 + 0.12 * normal[2], direct = 0.85 * share * std::max(0.0, dot(normal, sun));
        return sum_of({}, sky + direct, color);
    }

    MeshPoint normal_at(const SeenQuads::Seen& seen, const std::array<double, 2>& at) const
    {
        const auto& corners = normals_[seen.quad];
        const auto row = [&](std::size_t a, std::size_t b) {
            return sum_of(sum_of({}, 1 - seen.u, corners[a]), seen.u, corners[b]);
        };
        const MeshPoint smooth = unit(sum_of(sum_of({}, 1 - seen.v, row(0, 1)), seen.v, row(3, 2)));
        if (atlas_.normal.values.empty()) return smooth;
        const MeshPoint bump = sampled(atlas_.normal, at, [](std::uint8_t byte) { return byte / 127.5 - 1; });
        // The bump is given along the cell's own axes on the quad.
        const auto corner = [&](std::uint32_t k) {
            return mesh_.vertices[mesh_.quads[seen.quad][(k + atlas_.cells[seen.quad].first) % 4]];
        };
        MeshPoint right = sum_of(corner(1), -1, corner(0));
        right = unit(sum_of(right, -dot(right, smooth), smooth));
        const MeshPoint up{smooth[1] * right[2] - smooth[2] * right[1], smooth[2] * right[0] - smooth[0] * right[2],
                           smooth[0] * right[1] - smooth[1] * right[0]};
        return unit(sum_of(sum_of(sum_of({}, bump[0], right), bump[1], up), bump[2], smooth));
    }

    const QuadMesh& mesh_;
    const QuadAtlas& atlas_;
    std::vector<std::array<MeshPoint, 4>> normals_;
    double ground_ = INFINITY;
};

}

PngPixels quad_picture(const QuadMesh& mesh, const QuadTopology& topology, const QuadAtlas& atlas, int pixels)
{
    const int side = std::max(1, pixels / 2);
    PngPixels picture{2 * side, side, 3, {}};
    picture.values.resize(picture.at(0, side, 0));
    const QuadPainter painter(mesh, topology, atlas);
    painter.paint(picture, 0, side, -0.5);
    painter.paint(picture, side, side, 2.64);
    return picture;
}

}
