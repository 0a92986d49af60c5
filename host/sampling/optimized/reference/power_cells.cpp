// Power diagrams, plain and sequential: what the kernel must reproduce.
#include "host/sampling/optimized/power_cells.hpp"

#include "host/sampling/cells/cut_polygon.hpp"
#include "host/sampling/reference/plain_cells.hpp"
#include "kernels/common/optimized/power_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poissonlab::reference {
namespace {

using namespace contract::power_cells;

struct PowerNeighbour
{
    std::size_t id;
    double x, y; ///< from the site to this image of it
};

class PlainPowerDiagram
{
public:
    PlainPowerDiagram(const PointSet& points, const std::vector<double>& weights)
        : points_(points), weights_(weights), grid_size_(static_cast<int>(power_grid(points.size()))),
          cells_(points, grid_size_)
    {
        const auto [least, most] = std::ranges::minmax(weights);
        weight_range_ = most - least;
    }

    void measure(std::size_t id, PowerCells& result) const
    {
        std::vector<PowerNeighbour> neighbours; // those that cut, by the numbers that edges know
        const CutPolygon cell = cell_of(id, neighbours);
        double area = 0, energy = 0, moment_x = 0, moment_y = 0;
        std::size_t count = 0;
        for (std::size_t k = 0; k < cell.size(); ++k) {
            const CutVertex &a = cell[k], &b = cell[(k + 1) % cell.size()];
            const double doubled = a.x * b.y - a.y * b.x;
            area += doubled / 2;
            moment_x += doubled / 6 * (a.x + b.x);
            moment_y += doubled / 6 * (a.y + b.y);
            energy += doubled / 12 * ((a.x * a.x + a.y * a.y) + (b.x * b.x + b.y * b.y) + (a.x * b.x + a.y * b.y));
            if (a.neighbour == no_neighbour || count == MAX_NEIGHBORS) continue;
            const PowerNeighbour& other = neighbours[a.neighbour];
            if (other.id == id) continue;
            const double squared_length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
            result.neighbours[id * MAX_NEIGHBORS + count] = static_cast<std::uint32_t>(other.id);
            result.exchanges[id * MAX_NEIGHBORS + count] =
                std::sqrt(squared_length / (other.x * other.x + other.y * other.y)) / 2;
            ++count;
        }
        result.areas[id] = area;
        result.energies[id] = energy;
        result.displacements[2 * id] = area > 0 ? moment_x / area : 0;
        result.displacements[2 * id + 1] = area > 0 ? moment_y / area : 0;
    }

private:
    CutPolygon cell_of(std::size_t id, std::vector<PowerNeighbour>& neighbours) const
    {
        const auto place = cells_.cell_of(points_[id]);
        CutPolygon cell = square_around(1);
        double squared_radius = 2;
        for (int ring = 0; ring <= (MAX_TURNS + 1) * grid_size_; ++ring) {
            for (int y = -ring; y <= ring; ++y)
                for (int x = -ring; x <= ring; ++x) {
                    if (std::max(std::abs(x), std::abs(y)) != ring) continue;
                    bool is_covered = false;
                    cells_.for_each_in({place[0] + x, place[1] + y, 0}, [&](std::size_t other, const auto& turns) {
                        if (is_covered || (other == id && turns[0] == 0 && turns[1] == 0)) return;
                        if (std::max(std::abs(turns[0]), std::abs(turns[1])) > MAX_TURNS) return;
                        const double to_x = points_[other][0] + turns[0] - points_[id][0];
                        const double to_y = points_[other][1] + turns[1] - points_[id][1];
                        const double squared = to_x * to_x + to_y * to_y;
                        const double offset = (squared + weights_[id] - weights_[other]) / 2;
                        if (offset > 0 && offset * offset >= squared_radius * squared) return;
                        cell =
                            without_half_plane(cell, to_x, to_y, offset, static_cast<std::uint32_t>(neighbours.size()));
                        neighbours.push_back({other, to_x, to_y});
                        squared_radius = squared_radius_of(cell);
                        is_covered = cell.empty() || cell.size() > max_cut_vertices;
                    });
                    if (is_covered) return {};
                }
            const double beyond = ring * ((1 - 0x1p-40) / grid_size_);
            if (ring > 0 && beyond * beyond - weight_range_ >= 2 * beyond * std::sqrt(squared_radius)) break;
        }
        return cell;
    }

    const PointSet& points_;
    const std::vector<double>& weights_;
    int grid_size_;
    PlainCells cells_;
    double weight_range_ = 0;
};

}

PowerCells power_cells(const PointSet& points, const std::vector<double>& weights)
{
    const std::size_t n = points.size();
    const PlainPowerDiagram diagram(points, weights);
    PowerCells cells{std::vector<double>(n), std::vector<double>(2 * n), std::vector<double>(n),
                     std::vector<std::uint32_t>(MAX_NEIGHBORS * n, no_neighbour),
                     std::vector<double>(MAX_NEIGHBORS * n)};
    for (std::size_t id = 0; id < n; ++id) diagram.measure(id, cells);
    return cells;
}

}
