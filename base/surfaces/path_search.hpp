// The search of surface_paths.hpp: windows in a queue, by the length of the shortest path through them.
#pragma once

#include "base/surfaces/surface_paths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace poissonlab::paths {

inline constexpr std::uint32_t no_side = UINT32_MAX;
inline constexpr double no_path = std::numeric_limits<double>::infinity();

/// Angles, relative lengths and sines that differ by less are equal, because doubles round.
inline constexpr double rounding = 1e-12;

/// A place or a vector in an unfolded plane.
using PlanePoint = std::array<double, 2>;

inline PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline PlanePoint operator*(double k, const PlanePoint& a) { return {k * a[0], k * a[1]}; }

inline double across(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[1] - a[1] * b[0]; }
inline double along(const PlanePoint& a, const PlanePoint& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double length_of(const PlanePoint& a) { return std::sqrt(along(a, a)); }

inline double length_between(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b)
{
    const MeshPoint edge = difference(mesh.vertices[a], mesh.vertices[b]);
    return std::sqrt(dot(edge, edge));
}

/// Straight lines from a source or a bend at (0, 0) through a part of an edge, which enter the triangle of `side`; or
/// the bend at a vertex itself.
struct PathWindow
{
    double nearest = 0; ///< the length of the shortest path through it
    std::uint32_t side = no_side;
    std::uint32_t vertex = 0;           ///< of a bend, where `side` is none
    bool starts_left = false;           ///< the side's start is at the left end of the edge, as seen from (0, 0)
    PlanePoint left{}, right{};         ///< the ends of the edge
    PlanePoint left_ray{}, right_ray{}; ///< the outermost lines
    double before = 0;                  ///< the length of the path as far as (0, 0)
    PlanePoint leaves{};                ///< the direction in which paths begin, of bends

    bool operator<(const PathWindow& other) const { return nearest > other.nearest; } // the nearest one comes first
};

/// Is a place between the outermost lines of a window, or on one of them?
inline bool is_seen(const PlanePoint& place, const PathWindow& window)
{
    const auto is_between = [](const PlanePoint& right, const PlanePoint& left) {
        return across(right, left) >= -rounding * length_of(right) * length_of(left);
    };
    return is_between(window.right_ray, place) && is_between(place, window.left_ray);
}

/// Finds the paths from one source after another.
class PathSearch
{
public:
    explicit PathSearch(const SurfacePaths& paths)
        : paths_(paths), mesh_(paths.mesh_), to_vertex_(mesh_.vertices.size(), no_path), leaves_(mesh_.vertices.size()),
          to_target_(paths.targets_.size())
    {}

    std::vector<SurfacePath> from(const MeshPosition& source, double reach)
    {
        reach_ = reach;
        begin(source);
        while (!windows_.empty()) {
            const PathWindow window = windows_.top();
            windows_.pop();
            if (window.side != no_side)
                enter(window);
            else if (window.nearest <= to_vertex_[window.vertex])
                bend_at(window.vertex);
        }
        return collected(source.triangle);
    }

private:
    void begin(const MeshPosition& source)
    {
        const std::uint32_t first = 3 * source.triangle;
        const MeshTriangle& corners = mesh_.triangles[source.triangle];
        const double length = length_between(mesh_, corners[0], corners[1]);
        const PlanePoint top = paths_.tops_[first];
        const std::array<PlanePoint, 3> frame{{{0, 0}, {length, 0}, length * top}};
        const double inwards = std::ranges::min(source.shares) < 1e-9 ? 1e-9 : 0;
        PlanePoint place{};
        for (std::size_t c = 0; c < 3; ++c) place = place + ((1 - inwards) * source.shares[c] + inwards / 3) * frame[c];
        std::array<PlanePoint, 3> places{};
        for (std::size_t c = 0; c < 3; ++c) places[c] = frame[c] - place;
        PathWindow whole;
        offer_targets(source.triangle, places, whole);
        for (std::uint32_t c = 0; c < 3; ++c) offer(corners[c], places[c], whole);
        for (std::uint32_t c = 0; c < 3; ++c) leave_whole(first + c, places[c], places[(c + 1) % 3], whole);
    }

    /// Goes on from a vertex in all directions. Those that are no part of shortest paths are beaten.
    void bend_at(std::uint32_t vertex)
    {
        for (std::uint32_t i = paths_.fan_starts_[vertex]; i < paths_.fan_starts_[vertex + 1]; ++i) {
            const std::uint32_t side = paths_.fans_[i], triangle = side / 3, c = side % 3;
            const MeshTriangle& corners = mesh_.triangles[triangle];
            const std::uint32_t own = (c + 2) % 3, next = 3 * triangle + own; // from the vertex to the side's start
            const double length = length_between(mesh_, vertex, corners[c]);
            std::array<PlanePoint, 3> places{};
            places[c] = {length, 0};
            places[(c + 1) % 3] = length * paths_.tops_[next];
            PathWindow bend;
            bend.before = to_vertex_[vertex];
            bend.leaves = leaves_[vertex];
            offer_targets(triangle, places, bend);
            offer(corners[c], places[c], bend);
            offer(corners[(c + 1) % 3], places[(c + 1) % 3], bend);
            leave_whole(side, places[c], places[(c + 1) % 3], bend);
        }
    }

    /// Leaves a triangle in which (0, 0) lies through one of its sides.
    void leave_whole(std::uint32_t side, const PlanePoint& start, const PlanePoint& end, PathWindow window)
    {
        window.left = window.left_ray = end;
        window.right = window.right_ray = start;
        leave(side, false, window);
    }

    void enter(const PathWindow& window)
    {
        const std::uint32_t triangle = window.side / 3, c = window.side % 3;
        const PlanePoint edge = window.right - window.left, upwards{-edge[1], edge[0]};
        const PlanePoint top = paths_.tops_[window.side];
        const PlanePoint place = window.left + (window.starts_left ? top[0] : 1 - top[0]) * edge + top[1] * upwards;
        std::array<PlanePoint, 3> places{};
        places[c] = window.starts_left ? window.left : window.right;
        places[(c + 1) % 3] = window.starts_left ? window.right : window.left;
        places[(c + 2) % 3] = place;
        offer_targets(triangle, places, window);
        const bool is_right_of_left = across(place, window.left_ray) > 0,
                   is_left_of_right = across(window.right_ray, place) > 0;
        // A vertex behind another one lies on the outermost lines of both windows that this one divides.
        if (is_seen(place, window)) offer(mesh_.triangles[triangle][(c + 2) % 3], place, window);
        const std::uint32_t after = SurfacePaths::next_of(window.side), last = SurfacePaths::next_of(after);
        PathWindow on = window;
        if (is_right_of_left) {
            on.right = place;
            on.right_ray = is_left_of_right ? place : window.right_ray;
            leave(window.starts_left ? last : after, !window.starts_left, on);
        }
        if (is_left_of_right) {
            on = window;
            on.left = place;
            on.left_ray = is_right_of_left ? place : window.left_ray;
            leave(window.starts_left ? after : last, !window.starts_left, on);
        }
    }

    /// Enters all other triangles at a side, unless the window is out of reach or beaten.
    void leave(std::uint32_t side, bool starts_left, PathWindow window)
    {
        const std::uint32_t start = paths_.start_of(side), end = paths_.start_of(SurfacePaths::next_of(side));
        const std::uint32_t left = starts_left ? start : end, right = starts_left ? end : start;
        const PlanePoint edge = window.right - window.left;
        const auto part = [&](const PlanePoint& ray, double otherwise) {
            const double turn = across(ray, edge);
            return turn == 0 ? otherwise : std::clamp(-across(ray, window.left) / turn, 0.0, 1.0);
        };
        const double from = part(window.left_ray, 0), to = std::max(from, part(window.right_ray, 1));
        const PlanePoint first = window.left + from * edge, last = window.left + to * edge;
        const double foot = std::clamp(-along(window.left, edge) / along(edge, edge), from, to);
        window.nearest = window.before + length_of(window.left + foot * edge);
        if (!(window.nearest <= reach_)) return;
        const double slack = rounding * reach_;
        if (to_vertex_[left] + length_of(last - window.left) < window.before + length_of(last) - slack ||
            to_vertex_[right] + length_of(first - window.right) < window.before + length_of(first) - slack)
            return;
        const std::uint32_t group = paths_.group_of_[side];
        for (std::uint32_t i = paths_.group_starts_[group]; i < paths_.group_starts_[group + 1]; ++i) {
            if (paths_.sides_[i] == side) continue;
            window.side = paths_.sides_[i];
            window.starts_left = paths_.start_of(window.side) == left;
            windows_.push(window);
        }
    }

    void offer(std::uint32_t vertex, const PlanePoint& place, const PathWindow& window)
    {
        const double length = length_of(place), whole = window.before + length;
        if (!(whole < to_vertex_[vertex]) || whole > reach_) return;
        if (to_vertex_[vertex] == no_path) reached_.push_back(vertex);
        to_vertex_[vertex] = whole;
        leaves_[vertex] = window.before > 0 ? window.leaves : (1 / length) * place;
        if (!paths_.may_bend_[vertex]) return;
        PathWindow bend;
        bend.nearest = whole;
        bend.vertex = vertex;
        windows_.push(bend);
    }

    void offer_targets(std::uint32_t triangle, const std::array<PlanePoint, 3>& places, const PathWindow& window)
    {
        // Only targets whose feet on the first side are within reach of that of (0, 0) can be.
        const PlanePoint side = places[1] - places[0];
        const double squared = along(side, side), foot = -along(places[0], side) / squared,
                     within = (1 + rounding) * (reach_ - window.before) / std::sqrt(squared) + rounding;
        const auto first = paths_.target_along_.begin() + paths_.target_starts_[triangle],
                   last = paths_.target_along_.begin() + paths_.target_starts_[triangle + 1];
        const auto from = std::lower_bound(first, last, foot - within);
        auto i = static_cast<std::size_t>(from - paths_.target_along_.begin());
        for (; i < paths_.target_starts_[triangle + 1] && paths_.target_along_[i] <= foot + within; ++i) {
            const std::uint32_t target = paths_.target_order_[i];
            const std::array<double, 3>& shares = paths_.targets_[target].shares;
            const PlanePoint place = shares[0] * places[0] + shares[1] * places[1] + shares[2] * places[2];
            const double length = length_of(place), whole = window.before + length;
            if (whole > reach_) continue;
            if (window.side != no_side && !is_seen(place, window)) continue;
            SurfacePath& path = to_target_[target];
            if (path.length == 0) found_.push_back(target), path.length = no_path;
            if (!(whole < path.length)) continue;
            const PlanePoint way =
                window.before > 0 ? whole * window.leaves : place; // in the frame of the source's triangle
            // A path of length 0 would look like none.
            path = {target, std::max(whole, std::numeric_limits<double>::min()), {way[0], way[1], 0}};
        }
    }

    /// Returns the paths, with ways in space, and forgets them.
    std::vector<SurfacePath> collected(std::uint32_t triangle)
    {
        const auto& [a, b, c] = mesh_.triangles[triangle];
        const MeshPoint edge = difference(mesh_.vertices[b], mesh_.vertices[a]);
        const MeshPoint x = unit(edge), normal = unit(cross(edge, difference(mesh_.vertices[c], mesh_.vertices[a]))),
                        y = cross(normal, x);
        std::ranges::sort(found_);
        std::vector<SurfacePath> paths;
        for (const std::uint32_t target : found_) {
            SurfacePath path = to_target_[target];
            const MeshPoint way = path.way;
            for (std::size_t k = 0; k < 3; ++k) path.way[k] = way[0] * x[k] + way[1] * y[k];
            paths.push_back(path);
            to_target_[target] = {};
        }
        for (const std::uint32_t vertex : reached_) to_vertex_[vertex] = no_path;
        found_.clear();
        reached_.clear();
        return paths;
    }

    const SurfacePaths& paths_;
    const TriangleMesh& mesh_;
    double reach_ = 0;
    std::priority_queue<PathWindow> windows_;
    std::vector<double> to_vertex_;  ///< the shortest paths that are known
    std::vector<PlanePoint> leaves_; ///< their directions in the frame of the source's triangle
    std::vector<SurfacePath> to_target_;
    std::vector<std::uint32_t> reached_, found_; ///< vertices and targets that have a path
};

}
