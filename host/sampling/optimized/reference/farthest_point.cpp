// Farthest point optimization, plain and sequential: what the kernels must reproduce.
#include "host/sampling/optimized/farthest_point.hpp"

#include "host/sampling/cells/cut_polygon.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/reference/plain_cells.hpp"
#include "kernels/common/optimized/farthest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace poissonlab::reference {
namespace {

using namespace contract::farthest_point;

struct WindowPoint
{
    std::size_t id;
    double x, y; ///< with its repetition
};

/// The points around a cell, and its borders.
struct PointWindow
{
    std::vector<WindowPoint> points; ///< cell by cell
    double low_x, low_y, high_x, high_y;
};

/// A point as a place sees it.
struct SeenPoint
{
    double x, y, squared; ///< from the place, and the squared distance
    std::size_t index;    ///< in the window
};

class PlainFarthestState
{
public:
    explicit PlainFarthestState(const PointSet& points)
        : points_(snapped_down(points)), grid_size_(static_cast<int>(farthest_point_grid(points.size())))
    {}

    IterateMeasure measure()
    {
        const VoronoiCells cells = voronoi_cells(points_);
        return {lloyd_energy(std::accumulate(cells.energies.begin(), cells.energies.end(), 0.0), points_.size(), 2),
                *std::ranges::min_element(cells.squared_near)};
    }

    void move()
    {
        std::vector<bool> has_moved(points_.size());
        const int colors = std::min(int{COLORS}, grid_size_);
        for (int color = 0; color < colors * colors; ++color) {
            const PlainCells cells(points_, grid_size_); // points belong to their cells until all of a color have moved
            for (int y = color / colors; y < grid_size_; y += colors)
                for (int x = color % colors; x < grid_size_; x += colors)
                    cells.for_each_in({x, y, 0}, [&](std::size_t id, const auto&) {
                        if (!has_moved[id]) move_point(cells, {x, y, 0}, id);
                        has_moved[id] = true;
                    });
            // Until now they were where the windows are: points of a cell see each other across the torus' borders.
            for (double& c : points_.coordinates) c -= std::floor(c);
        }
    }

    void keep() { kept_ = points_; }
    PointSet kept() { return std::move(kept_); }

private:
    PointWindow window_around(const PlainCells& cells, const std::array<int, 3>& cell) const
    {
        PointWindow window;
        for (int y = -NEIGHBOUR_REACH; y <= NEIGHBOUR_REACH; ++y)
            for (int x = -NEIGHBOUR_REACH; x <= NEIGHBOUR_REACH; ++x) {
                cells.for_each_in({cell[0] + x, cell[1] + y, 0}, [&](std::size_t id, const std::array<int, 3>& turns) {
                    window.points.push_back({id, points_[id][0] + turns[0], points_[id][1] + turns[1]});
                });
            }
        const double width = 1.0 / grid_size_;
        window.low_x = (cell[0] - NEIGHBOUR_REACH) * width;
        window.low_y = (cell[1] - NEIGHBOUR_REACH) * width;
        window.high_x = (cell[0] + NEIGHBOUR_REACH + 1) * width;
        window.high_y = (cell[1] + NEIGHBOUR_REACH + 1) * width;
        return window;
    }

    /// The Voronoi cell of a place among the points of the window without one; the nearest of them cut first. `own` is
    /// the place's point, if it has one. Empty where it has too many vertices, or too many points are at one distance.
    static CutPolygon cell_without(const PointWindow& window, double x, double y, std::size_t own, std::size_t left_out)
    {
        std::vector<SeenPoint> neighbours;
        for (std::size_t i = 0; i < window.points.size(); ++i) {
            const WindowPoint& point = window.points[i];
            if (point.id == left_out || i == own) continue;
            const double to_x = point.x - x, to_y = point.y - y;
            neighbours.push_back({to_x, to_y, to_x * to_x + to_y * to_y, i});
        }
        std::ranges::stable_sort(neighbours, {}, &SeenPoint::squared);
        const double far = (window.high_x - window.low_x) + (window.high_y - window.low_y);
        CutPolygon cell = square_around(far);
        double squared_radius = 2 * far * far;
        for (std::size_t k = 0; k < neighbours.size() && neighbours[k].squared < 4 * squared_radius; ++k) {
            const SeenPoint& n = neighbours[k];
            if (k + BATCH < neighbours.size() && neighbours[k + BATCH].squared == n.squared) return {};
            cell = without_side(cell, n.x, n.y, static_cast<std::uint32_t>(n.index));
            if (cell.size() > max_cut_vertices) return {};
            squared_radius = squared_radius_of(cell);
        }
        return cell;
    }

    static double squared_near_of(const PointWindow& window, std::size_t id, double x, double y)
    {
        double near = std::numeric_limits<double>::infinity();
        for (const WindowPoint& point : window.points) {
            const double to_x = point.x - x, to_y = point.y - y;
            if (point.id != id) near = std::min(near, to_x * to_x + to_y * to_y);
        }
        return near;
    }

    static bool is_inside(const PointWindow& window, double x, double y, double radius)
    {
        return x - radius >= window.low_x && x + radius <= window.high_x && y - radius >= window.low_y &&
               y + radius <= window.high_y;
    }

    void move_point(const PlainCells& cells, const std::array<int, 3>& its_cell, std::size_t id)
    {
        const PointWindow window = window_around(cells, its_cell);
        double farthest_x = points_[id][0], farthest_y = points_[id][1];
        double most = squared_near_of(window, id, farthest_x, farthest_y);
        for (const CutVertex& edge : cell_without(window, farthest_x, farthest_y, SIZE_MAX, id)) {
            if (edge.neighbour == no_neighbour) continue;
            const WindowPoint& neighbour = window.points[edge.neighbour];
            for (const CutVertex& vertex : cell_without(window, neighbour.x, neighbour.y, edge.neighbour, id)) {
                const double squared = vertex.x * vertex.x + vertex.y * vertex.y;
                const double x = neighbour.x + vertex.x, y = neighbour.y + vertex.y;
                if (!(squared > most) || !is_inside(window, x, y, std::sqrt(squared))) continue;
                most = squared;
                farthest_x = x;
                farthest_y = y;
            }
        }
        const auto snapped = [](double coordinate) { return std::floor(coordinate * 0x1p32 + 0.5) / 0x1p32; };
        points_.coordinates[2 * id] = snapped(farthest_x);
        points_.coordinates[2 * id + 1] = snapped(farthest_y);
    }

    PointSet points_;
    int grid_size_;
    PointSet kept_;
};

}

LloydResult move_to_farthest(const PointSet& points, const LloydRequest& request)
{
    PlainFarthestState state(points);
    return run_iterations(state, points.size(), 2, request);
}

}
