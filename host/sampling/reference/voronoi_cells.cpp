// Voronoi cells from CGAL's periodic Delaunay triangulations: what the kernels are held against.
#include "host/sampling/cells/voronoi_cells.hpp"

#include "base/geometry/point_set.hpp"
#include "base/geometry/torus_delaunay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace poissonlab::reference {
namespace {

// Points by position: triangulations know each position once.

/// Finds the numbers of all points at a position.
class PositionIndex
{
public:
    explicit PositionIndex(const PointSet& points) : points_(points), order_(points.size())
    {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
            return std::ranges::lexicographical_compare(points_[a], points_[b]);
        });
    }

    /// The numbers of the points at a position, in ascending order.
    std::span<const std::size_t> at(std::span<const double> position) const
    {
        const auto less = [](std::span<const double> a, std::span<const double> b) {
            return std::ranges::lexicographical_compare(a, b);
        };
        const auto of = [&](std::size_t i) { return points_[i]; };
        return {std::ranges::lower_bound(order_, position, less, of),
                std::ranges::upper_bound(order_, position, less, of)};
    }

private:
    const PointSet& points_;
    std::vector<std::size_t> order_;
};

/// The part of a cell that the i-th of n coinciding points gets: positions x with side * x >= 0 relative to
/// the point, all (0), or nothing.
enum class Share
{
    all = 0,
    left = -1,
    right = 1,
    nothing
};

Share share_of(std::size_t i, std::size_t n)
{
    if (n == 1) return Share::all;
    return i == 0 ? Share::left : i + 1 == n ? Share::right : Share::nothing;
}

template <int D>
struct Integral
{
    double volume = 0;
    std::array<double, D> moment{};
    double energy = 0;
};

using Position2 = std::array<double, 2>;
using Position3 = std::array<double, 3>;

/// The part of an edge on one side of the site; false where there is none.
bool clip(Position2& p, Position2& q, Share share)
{
    if (share == Share::all) return true;
    const double side = share == Share::left ? -1 : 1;
    if (side * p[0] < 0 && side * q[0] < 0) return false;
    if (side * p[0] >= 0 && side * q[0] >= 0) return true;
    const double y = (p[1] * q[0] - q[1] * p[0]) / (q[0] - p[0]);
    (side * p[0] < 0 ? p : q) = {0, y};
    return true;
}

Integral<2> integrate(const TorusCell<2>& cell, Share share)
{
    Integral<2> integral;
    const auto& polygon = cell.faces[0];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Position2 p = polygon[i];
        Position2 q = polygon[(i + 1) % polygon.size()];
        if (!clip(p, q, share)) continue;
        // A triangle with the site as its third vertex. What clipping cuts off ends at the site, so nothing
        // is missing.
        const double area = (p[0] * q[1] - p[1] * q[0]) / 2;
        integral.volume += area;
        for (int k = 0; k < 2; ++k) {
            integral.moment[k] += area * (p[k] + q[k]) / 3;
            integral.energy += area * (p[k] * p[k] + q[k] * q[k] + p[k] * q[k]) / 6;
        }
    }
    return integral;
}

using Polygon3 = TorusCell<3>::Polygon;

/// The part of a face on one side of the site (Sutherland and Hodgman).
Polygon3 clipped(const Polygon3& face, Share share)
{
    if (share == Share::all) return face;
    const double side = share == Share::left ? -1 : 1;
    Polygon3 result;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Position3& p = face[i];
        const Position3& q = face[(i + 1) % face.size()];
        if (side * p[0] >= 0) result.push_back(p);
        if ((side * p[0] >= 0) == (side * q[0] >= 0)) continue;
        const double t = p[0] / (p[0] - q[0]);
        result.push_back({0, p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
    }
    return result;
}

void add_tetrahedron(const Position3& p, const Position3& q, const Position3& r, Integral<3>& integral)
{
    const double volume = std::abs(p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                                   p[2] * (q[0] * r[1] - q[1] * r[0])) /
                          6;
    integral.volume += volume;
    for (int k = 0; k < 3; ++k) {
        const double sum = p[k] + q[k] + r[k];
        integral.moment[k] += volume * sum / 4;
        integral.energy += volume * (sum * sum + p[k] * p[k] + q[k] * q[k] + r[k] * r[k]) / 20;
    }
}

/// Pyramids with the site as apex. The face that clipping makes holds the site, so it adds nothing.
Integral<3> integrate(const TorusCell<3>& cell, Share share)
{
    Integral<3> integral;
    for (const Polygon3& whole : cell.faces) {
        const Polygon3 face = clipped(whole, share);
        for (std::size_t i = 2; i < face.size(); ++i) add_tetrahedron(face[0], face[i - 1], face[i], integral);
    }
    return integral;
}

/// Takes the cells of positions, and deals them out to the points that lie there.
template <int D>
class CellsOfPoints
{
public:
    explicit CellsOfPoints(const PointSet& points)
        : index_(points), cells_{D, std::vector<double>(points.size()), std::vector<double>(D * points.size()),
                                 std::vector<double>(points.size()), std::vector<double>(points.size())}
    {}

    void take(const TorusCell<D>& cell)
    {
        const auto sites = index_.at(cell.site);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const Share share = share_of(i, sites.size());
            const Integral<D> integral = share == Share::nothing ? Integral<D>{} : integrate(cell, share);
            const std::size_t id = sites[i];
            cells_.volumes[id] = integral.volume;
            cells_.energies[id] = integral.energy;
            cells_.squared_near[id] = sites.size() > 1 ? 0 : cell.squared_near;
            for (std::size_t k = 0; k < D; ++k)
                cells_.displacements[D * id + k] = integral.volume > 0 ? integral.moment[k] / integral.volume : 0;
        }
    }

    VoronoiCells result() && { return std::move(cells_); }

private:
    PositionIndex index_;
    VoronoiCells cells_;
};

}

VoronoiCells voronoi_cells(const PointSet& points)
{
    if (points.dimension == 2) {
        CellsOfPoints<2> cells(points);
        visit_voronoi_cells_2d(points, [&](const TorusCell<2>& cell) { cells.take(cell); });
        return std::move(cells).result();
    }
    CellsOfPoints<3> cells(points);
    visit_voronoi_cells_3d(points, [&](const TorusCell<3>& cell) { cells.take(cell); });
    return std::move(cells).result();
}

}
