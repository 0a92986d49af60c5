#include "host/distribution/surfaces/relaxed_surface.hpp"

#include "host/distribution/surfaces/surface_moves.hpp"
#include "host/sampling/cells/cut_polygon.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace poissonlab {

RelaxedSurface relax_on_surface(const FixedSurface& surface, std::vector<SurfacePoint> points,
                                const MeshPointSettings& settings, const std::function<void(std::size_t)>& on_step)
{
    const SurfaceMoves moves(surface, settings.normal_angle);
    const SurfaceCells cells(surface, points.size(), settings.normal_angle);
    const double units = surface.area / (surface.unit * surface.unit), count = static_cast<double>(points.size());
    const double hexagons = 5 * std::numbers::sqrt3 / 54 * units / count;
    RelaxedSurface relaxed{std::move(points), {}};
    for (std::size_t step = 0;; ++step) {
        const std::vector<SurfaceCell> found = cells.of(relaxed.points);
        double energy = 0;
        for (const SurfaceCell& cell : found) energy += cell.energy;
        relaxed.energies.push_back(energy / units / hexagons);
        if (step == iterations_of(settings)) return relaxed;
        if (on_step) on_step(step);
        tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t i) {
            const SurfaceCell& cell = found[i];
            if (cell.area <= 0) return;
            const MeshPoint by{cell.moment[0] / cell.area, cell.moment[1] / cell.area, cell.moment[2] / cell.area};
            relaxed.points[i] = moves.moved(relaxed.points[i], by);
        });
    }
}

namespace {

/// Pieces are no larger than so many cells, and so many of them are cut by one task.
constexpr double cells_of_piece = 8;
constexpr std::size_t pieces_of_task = 64;

/// Neighbours are listed up to so many mean distances: of even sets, hardly a cell reaches half as far.
constexpr double listed_distances = 2.5;

struct ListedNeighbour
{
    std::uint64_t squared = 0; ///< distance
    std::uint32_t number = 0;

    auto operator<=>(const ListedNeighbour&) const = default;
};

/// A part of a cell, and the point whose cell it is.
struct CellPart
{
    std::uint32_t point = 0;
    SurfaceCell cell;
};

MeshPoint between(const MeshPlace& from, const MeshPlace& to)
{
    return {double(to[0] - from[0]), double(to[1] - from[1]), double(to[2] - from[2])};
}

/// A plane triangle with axes of its own.
struct PlanePiece
{
    std::uint32_t triangle = 0;
    std::array<MeshPlace, 3> corners{};
    MeshPoint x{}, y{}, normal{}; ///< of length 1

    PlanePiece(const FixedSurface& surface, const SurfacePiece& piece) : triangle(piece.triangle)
    {
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = place_on(surface.triangles[triangle], piece.shares[2 * i], piece.shares[2 * i + 1]);
        const MeshPoint edge = between(corners[0], corners[1]);
        x = unit(edge);
        normal = unit(cross(edge, between(corners[0], corners[2])));
        y = cross(normal, x);
    }

    MeshPlace middle() const
    {
        MeshPlace sum{};
        for (std::size_t k = 0; k < 3; ++k) sum[k] = (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
        return sum;
    }
};

/// Integrates over a polygon of the plane at a height above a point, which lies at (0, 0).
SurfaceCell integrals_over(const CutPolygon& polygon, double height, const PlanePiece& piece)
{
    double area = 0, along_x = 0, along_y = 0, squares = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const CutVertex &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
        const double part = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
        const double x = a.x + b.x + c.x, y = a.y + b.y + c.y;
        area += part;
        along_x += part * x / 3;
        along_y += part * y / 3;
        squares += part / 12 * (a.x * a.x + a.y * a.y + b.x * b.x + b.y * b.y + c.x * c.x + c.y * c.y + x * x + y * y);
    }
    SurfaceCell cell{area, {}, squares + area * height * height};
    for (std::size_t k = 0; k < 3; ++k)
        cell.moment[k] = along_x * piece.x[k] + along_y * piece.y[k] + area * height * piece.normal[k];
    return cell;
}

/// Cuts pieces for one set of points.
class CutPieces
{
public:
    CutPieces(const FixedSurface& surface, const std::vector<SurfacePoint>& points, std::int32_t least_cosine,
              std::uint64_t reach)
        : surface_(surface), points_(points), least_cosine_(least_cosine), near_(surface, points, reach),
          squared_reach_(reach * reach), listed_(points.size())
    {
        tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
            near_.for_each_around(place_of(points[i]), [&](std::uint32_t other) {
                const std::uint64_t squared = squared_distance(place_of(points[i]), place_of(points[other]));
                if (other != i && squared <= squared_reach_) listed_[i].push_back({squared, other});
            });
            std::ranges::sort(listed_[i]);
        });
    }

    /// The cells that have a part of the piece: that of its middle, and those beyond their sides.
    void add_parts(const SurfacePiece& of, std::vector<CellPart>& parts) const
    {
        const PlanePiece piece(surface_, of);
        const std::optional<std::uint32_t> first = nearest(piece.middle(), piece.triangle);
        if (!first) return;
        std::vector<std::uint32_t> found{*first};
        for (std::size_t i = 0; i < found.size(); ++i) {
            const MeshPoint origin = between(place_of(points_[found[i]]), piece.corners[0]);
            const double height = dot(origin, piece.normal);
            const CutPolygon polygon = part_of(piece, found[i], height);
            if (polygon.size() < 3) continue;
            parts.push_back({found[i], integrals_over(polygon, height, piece)});
            for (const CutVertex& vertex : polygon)
                if (vertex.neighbour != no_neighbour && std::ranges::find(found, vertex.neighbour) == found.end())
                    found.push_back(vertex.neighbour);
        }
    }

private:
    bool is_seen(std::uint32_t triangle, std::uint32_t point) const
    {
        return cosine_between(surface_.triangles[triangle], surface_.triangles[points_[point].triangle]) >=
               least_cosine_;
    }

    /// The nearest point that a triangle sees from a place of it; of equally near ones, that of the least number.
    std::optional<std::uint32_t> nearest(const MeshPlace& place, std::uint32_t triangle) const
    {
        ListedNeighbour best{std::numeric_limits<std::uint64_t>::max(), no_neighbour};
        const auto look_at = [&](std::uint32_t i) {
            const ListedNeighbour other{squared_distance(place, place_of(points_[i])), i};
            if (other < best && is_seen(triangle, i)) best = other;
        };
        near_.for_each_around(place, look_at);
        if (best.squared > squared_reach_)
            for (std::uint32_t i = 0; i < points_.size(); ++i) look_at(i);
        if (best.number == no_neighbour) return {};
        return best.number;
    }

    /// The polygon of a point's cell in a piece, relative to the foot of the perpendicular from the point.
    CutPolygon part_of(const PlanePiece& piece, std::uint32_t point, double height) const
    {
        const MeshPlace place = place_of(points_[point]);
        CutPolygon polygon;
        for (const MeshPlace& corner : piece.corners) {
            const MeshPoint from = between(place, corner);
            polygon.push_back({dot(from, piece.x), dot(from, piece.y), no_neighbour});
        }
        // Points that are farther away than twice the farthest corner do not cut.
        const auto cuts = [&](std::uint64_t squared) {
            return static_cast<double>(squared) <= 4 * (squared_radius_of(polygon) + height * height);
        };
        const auto cut = [&](std::uint32_t other) {
            if (!is_seen(piece.triangle, other)) return;
            const MeshPoint away = between(place, place_of(points_[other]));
            const double x = dot(away, piece.x), y = dot(away, piece.y);
            if (x == 0 && y == 0 && dot(away, away) == 0) {
                if (other < point) polygon.clear(); // the first of points at one place has their cell
                return;
            }
            polygon = without_half_plane(polygon, x, y, dot(away, away) / 2 - height * dot(away, piece.normal), other);
        };
        for (const ListedNeighbour& other : listed_[point]) {
            if (!cuts(other.squared)) return polygon;
            cut(other.number);
        }
        if (!polygon.empty() && cuts(squared_reach_))
            for (std::uint32_t i = 0; i < points_.size(); ++i) {
                const std::uint64_t squared = squared_distance(place, place_of(points_[i]));
                if (i != point && squared > squared_reach_ && cuts(squared)) cut(i);
            }
        return polygon;
    }

    const FixedSurface& surface_;
    const std::vector<SurfacePoint>& points_;
    std::int32_t least_cosine_;
    SurfaceNeighbours near_;
    std::uint64_t squared_reach_;
    std::vector<std::vector<ListedNeighbour>> listed_; ///< of each point, the nearest first
};

}

SurfaceCells::SurfaceCells(const FixedSurface& surface, std::size_t points, double normal_angle)
    : surface_(surface), pieces_(whole_pieces(surface)), least_cosine_(least_cosine(normal_angle))
{
    const double mean = surface.area / static_cast<double>(points);
    constexpr std::uint64_t widest = std::uint64_t{1} << (contract::surface::COORDINATE_BITS + 1);
    reach_ = std::min(static_cast<std::uint64_t>(listed_distances * surface.units_of(std::sqrt(mean))) + 1, widest);
    for (bool is_finer = true; is_finer;) {
        for (SurfacePiece& piece : pieces_)
            if (area_of(surface, piece) <= cells_of_piece * mean) piece.halvings |= LAST_PIECE;
        RefinedPieces halved =
            refined(surface, pieces_, std::vector<std::uint32_t>(pieces_.size(), contract::surface::PIECE_OPEN));
        pieces_ = std::move(halved.pieces);
        is_finer = halved.is_finer;
    }
}

std::vector<SurfaceCell> SurfaceCells::of(const std::vector<SurfacePoint>& points) const
{
    const CutPieces cut(surface_, points, least_cosine_, reach_);
    std::vector<std::vector<CellPart>> parts((pieces_.size() + pieces_of_task - 1) / pieces_of_task);
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t task) {
        const std::size_t end = std::min((task + 1) * pieces_of_task, pieces_.size());
        for (std::size_t i = task * pieces_of_task; i < end; ++i) cut.add_parts(pieces_[i], parts[task]);
    });
    std::vector<SurfaceCell> cells(points.size());
    for (const std::vector<CellPart>& of_task : parts)
        for (const auto& [point, part] : of_task) {
            SurfaceCell& cell = cells[point];
            cell.area += part.area;
            cell.energy += part.energy;
            for (std::size_t k = 0; k < 3; ++k) cell.moment[k] += part.moment[k];
        }
    return cells;
}

}
