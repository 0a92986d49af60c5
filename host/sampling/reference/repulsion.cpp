// Repulsion, plain and sequential: what the kernels must reproduce.
#include "host/sampling/repulsion.hpp"

#include "host/sampling/reference/plain_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace poissonlab::reference {
namespace {

bool is_held(const Domain& domain, std::size_t id) { return !domain.is_fixed.empty() && domain.is_fixed[id] != 0; }

/// One pass: the displacement of each point. Returns the squared minimum distance before it.
double find_displacements(const PointSet& points, const Domain& domain, const RepulsionPass& pass,
                          std::vector<Vector>& displacements)
{
    const PlainCells cells(points, static_cast<int>(pass.cells_per_axis));
    const int reach = pass.reach;
    const int reach_z = points.dimension == 3 ? reach : 0;
    const auto d = static_cast<std::size_t>(points.dimension);
    double near = 1; // each point's own images

    for (std::size_t id = 0; id < points.size(); ++id) {
        Vector sum{};
        const auto push_from = [&](std::size_t other, const std::array<int, 3>& repetition) {
            if (other == id) return;
            Vector difference{};
            double squared = 0;
            for (std::size_t k = 0; k < d; ++k) {
                difference[k] = points[other][k] - points[id][k] + repetition[k];
                squared += difference[k] * difference[k];
            }
            near = std::min(near, squared);
            const double length = std::sqrt(squared);
            if (length >= pass.distance) return;
            const double push = (is_held(domain, other) ? 1 : 0.5) * (pass.distance - length);
            if (length == 0) {
                sum[0] += id < other ? -push : push;
            } else {
                for (std::size_t k = 0; k < d; ++k) sum[k] -= difference[k] / length * push;
            }
        };
        const auto [x, y, z] = cells.cell_of(points[id]);
        for (int k = -reach_z; k <= reach_z; ++k) {
            for (int j = -reach; j <= reach; ++j) {
                for (int i = -reach; i <= reach; ++i) cells.for_each_in({x + i, y + j, z + k}, push_from);
            }
        }

        double squared = 0;
        for (const double s : sum) squared += s * s;
        const double length = std::sqrt(squared);
        const double scale = is_held(domain, id) ? 0 : length > pass.limit ? pass.limit / length : 1;
        for (std::size_t k = 0; k < 3; ++k) displacements[id][k] = scale * sum[k];
    }
    return near;
}

void move(PointSet& points, const Domain& domain, const std::vector<Vector>& displacements)
{
    const auto d = static_cast<std::size_t>(points.dimension);
    for (std::size_t id = 0; id < points.size(); ++id) {
        if (is_held(domain, id)) continue;
        Vector position{};
        for (std::size_t k = 0; k < d; ++k) position[k] = points[id][k];
        const Vector moved = allowed_displacement(domain, position, displacements[id], true);
        for (std::size_t k = 0; k < d; ++k) {
            const double sum = position[k] + moved[k];
            const double wrapped = sum - std::floor(sum);
            points.coordinates[id * d + k] = wrapped < 1 ? wrapped : 0;
        }
    }
}

}

RepulsionResult repel(const PointSet& points, const Domain& domain, const RepulsionRequest& request)
{
    const RepulsionPass pass = repulsion_pass(request, points.size(), points.dimension);
    PointSet current = points;
    std::vector<Vector> displacements(points.size());
    RepulsionResult best{points, 0, -1};
    for (std::size_t made = 0;; ++made) {
        best.passes = made;
        const double reached = std::sqrt(find_displacements(current, domain, pass, displacements));
        if (reached > best.min_distance) {
            best.min_distance = reached;
            best.points = current;
        }
        if (reached >= request.min_distance || made == request.passes) return best;
        move(current, domain, displacements);
    }
}

}
