#include "host/distribution/surfaces/relaxed_surface.hpp"

#include "host/distribution/surfaces/surface_cells.hpp"
#include "host/distribution/surfaces/surface_moves.hpp"

#include <tbb/parallel_for.h>

#include <numbers>

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

}
