// Lloyd relaxation by CGAL's Voronoi cells.
#include "host/sampling/lloyd_relaxation.hpp"

#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/reference/reference_engine.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
void need_reference_engine() {}
}

namespace poissonlab::reference {
namespace {

class PlainState
{
public:
    PlainState(const PointSet& points, const Domain& domain) : points_(points), domain_(domain) {}

    IterateMeasure measure()
    {
        cells_ = voronoi_cells(points_);
        const double integral = std::accumulate(cells_.energies.begin(), cells_.energies.end(), 0.0);
        return {lloyd_energy(integral, points_.size(), points_.dimension),
                *std::min_element(cells_.squared_near.begin(), cells_.squared_near.end())};
    }

    void move()
    {
        const auto d = static_cast<std::size_t>(points_.dimension);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!domain_.is_fixed.empty() && domain_.is_fixed[i] != 0) continue;
            Vector position{};
            Vector displacement{};
            for (std::size_t k = 0; k < d; ++k) {
                position[k] = points_.coordinates[i * d + k];
                displacement[k] = cells_.displacements[i * d + k];
            }
            const Vector movement = allowed_displacement(domain_, position, displacement, false);
            for (std::size_t k = 0; k < d; ++k) {
                const double moved = position[k] + movement[k];
                const double wrapped = moved - std::floor(moved);
                points_.coordinates[i * d + k] = wrapped < 1 ? wrapped : 0; // just below 0, the sum rounds to 1
            }
        }
    }

    void keep() { kept_ = points_; }
    PointSet kept() { return std::move(kept_); }

private:
    PointSet points_;
    const Domain& domain_;
    VoronoiCells cells_;
    PointSet kept_;
};

}

LloydResult relax(const PointSet& points, const Domain& domain, const LloydRequest& request)
{
    PlainState state(points, domain);
    return run_iterations(state, points.size(), points.dimension, request);
}

}
