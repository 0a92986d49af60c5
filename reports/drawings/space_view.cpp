#include "reports/drawings/space_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double degree = std::numbers::pi / 180;
const double turn = 33 * degree;      // of the x axis from the right
const double elevation = 24 * degree; // of the viewer

const ShapeVector to_viewer{std::sin(turn) * std::cos(elevation), -std::cos(turn) * std::cos(elevation),
                            std::sin(elevation)};
const ShapeVector to_light{-0.25, -0.55, 0.8};

/// Lattice planes that regions share are exact to this; units.
constexpr double tolerance = 1e-3;

double dot(const ShapeVector& a, const ShapeVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double length(const ShapeVector& a) { return std::sqrt(dot(a, a)); }

ShapeVector middle_of(const RegionShape& body)
{
    ShapeVector sum{};
    double count = 0;
    for (const ShapeFace& face : body.faces)
        for (const ShapeVector& corner : face.corners) {
            for (std::size_t k = 0; k < 3; ++k) sum[k] += corner[k];
            ++count;
        }
    for (double& coordinate : sum) coordinate /= count;
    return sum;
}

/// Is all of a body on the outer side of a face's plane?
bool is_outside(const RegionShape& body, const ShapeFace& face)
{
    const double limit = dot(face.normal, face.corners.front()) - tolerance * length(face.normal);
    return std::ranges::all_of(body.faces, [&](const ShapeFace& other) {
        return std::ranges::all_of(other.corners,
                                   [&](const ShapeVector& corner) { return dot(face.normal, corner) >= limit; });
    });
}

/// Do faces of `a` separate it from a body `b` that it can hide, or that can hide it? Both: neither hides the
/// other.
struct Separation
{
    bool hides = false;
    bool is_hidden = false;
};

Separation separation(const RegionShape& a, const RegionShape& b)
{
    Separation found;
    for (const ShapeFace& face : a.faces) {
        if (!is_outside(b, face)) continue;
        const double sight = dot(face.normal, to_viewer);
        // Beyond a face in sight there is what may hide the body; across the line of sight, nothing hides
        // anything.
        if (sight >= 0) found.is_hidden = true;
        if (sight <= 0) found.hides = true;
    }
    return found;
}

/// Must `a` be drawn before `b`?
bool is_behind(const RegionShape& a, const RegionShape& b)
{
    const Separation of_a = separation(a, b), of_b = separation(b, a);
    const bool may_be_hidden = of_a.is_hidden || of_b.hides;
    const bool may_hide = of_a.hides || of_b.is_hidden;
    return may_be_hidden && !may_hide;
}

}

DrawingPoint projected(const ShapeVector& p)
{
    const double back = p[1] * std::cos(turn) - p[0] * std::sin(turn);
    return {p[0] * std::cos(turn) + p[1] * std::sin(turn), -back * std::sin(elevation) - p[2] * std::cos(elevation)};
}

double nearness(const ShapeVector& place) { return dot(place, to_viewer); }

bool is_in_sight(const ShapeVector& normal) { return dot(normal, to_viewer) > 0; }

double light_on(const ShapeVector& normal)
{
    return std::clamp(0.5 + 0.5 * dot(normal, to_light) / length(normal) / length(to_light), 0.0, 1.0);
}

std::vector<std::size_t> back_to_front(const std::vector<RegionShape>& bodies)
{
    std::vector<std::vector<bool>> behind(bodies.size(), std::vector<bool>(bodies.size()));
    for (std::size_t i = 0; i < bodies.size(); ++i)
        for (std::size_t j = 0; j < bodies.size(); ++j) behind[i][j] = i != j && is_behind(bodies[i], bodies[j]);
    std::vector<std::size_t> order;
    std::vector<bool> done(bodies.size());
    while (order.size() < bodies.size()) {
        // Next is the farthest of those that hide none of the rest; should all hide some, the farthest of all.
        std::size_t next = bodies.size();
        double best = std::numeric_limits<double>::infinity();
        bool is_free = false;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (done[i]) continue;
            bool hides_none = true;
            for (std::size_t j = 0; j < bodies.size(); ++j) hides_none = hides_none && (done[j] || !behind[j][i]);
            const double near = nearness(middle_of(bodies[i]));
            if ((hides_none && !is_free) || (hides_none == is_free && near < best)) {
                next = i;
                best = near;
                is_free = hides_none;
            }
        }
        done[next] = true;
        order.push_back(next);
    }
    return order;
}

std::array<ShapeVector, 8> window_corners(const ScenePanel& panel)
{
    std::array<ShapeVector, 8> corners;
    corners.fill(panel.window.low_corner());
    for (std::size_t upper = 0; upper < corners.size(); ++upper)
        for (std::size_t k = 0; k < 3; ++k)
            if (upper >> k & 1) corners[upper][k] += panel.window.size[k];
    return corners;
}

std::array<DrawingPoint, 2> projected_window(const ScenePanel& panel)
{
    const DrawingPoint first = projected(panel.window.low_corner());
    std::array<DrawingPoint, 2> ends{first, first};
    for (const ShapeVector& corner : window_corners(panel))
        for (std::size_t k = 0; k < 2; ++k) {
            ends[0][k] = std::min(ends[0][k], projected(corner)[k]);
            ends[1][k] = std::max(ends[1][k], projected(corner)[k]);
        }
    return ends;
}

}
