#include "host/distribution/surfaces/relaxed_surface.hpp"

#include "host/distribution/surfaces/given_points.hpp"
#include "host/distribution/surfaces/surface_cells.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

using contract::gaussian_blue_noise::CUT_OFF;

/// exp(-x) for x from 0 to CUT_OFF^2 / 2, by additions and multiplications alone: they are the same on every machine.
/// The series of exp(-x / 128) is exact to the last bit but one after ten terms.
double falling_exponential(double x)
{
    const double part = x / 128;
    double power = 1;
    for (int n = 10; n > 0; --n) power = 1 - part / n * power;
    for (int doubled = 0; doubled < 7; ++doubled) power *= power;
    return power;
}

/// Moves points to places in units of the grid.
class SurfaceMoves
{
public:
    SurfaceMoves(const FixedSurface& surface, double normal_angle)
        : surface_(surface), mesh_(triangles_on_grid(surface)), tree_(mesh_), least_cosine_(least_cosine(normal_angle))
    {}

    SurfacePoint moved(const SurfacePoint& point, const MeshPoint& by) const
    {
        MeshPoint place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = point.place[k] + by[k];
        const SurfaceTriangle& own = surface_.triangles[point.triangle];
        const MeshPosition nearest = tree_.nearest(place, [&](std::uint32_t triangle) {
            return cosine_between(own, surface_.triangles[triangle]) >= least_cosine_;
        });
        return surface_point(surface_, nearest, place);
    }

private:
    const FixedSurface& surface_;
    TriangleMesh mesh_;
    TriangleTree tree_;
    std::int32_t least_cosine_;
};

/// The sum of Gaussians at a point, and of these times the vectors from their points.
struct GaussianPull
{
    double sum = 0;
    MeshPoint away{};
};

GaussianPull pull_at(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                     const SurfaceNeighbours& near, std::size_t own, double sigma, std::int32_t least_cosine)
{
    const SurfacePoint& point = points[own];
    const double squared_cut = CUT_OFF * CUT_OFF * sigma * sigma;
    GaussianPull pull;
    near.for_each_around(place_of(point), [&](std::uint32_t i) {
        MeshPoint away{};
        for (std::size_t k = 0; k < 3; ++k) away[k] = double(point.place[k]) - points[i].place[k];
        const double squared = dot(away, away);
        if (i == own || squared >= squared_cut ||
            cosine_between(surface.triangles[point.triangle], surface.triangles[points[i].triangle]) < least_cosine)
            return;
        const double gaussian = falling_exponential(squared / (2 * sigma * sigma));
        pull.sum += gaussian;
        for (std::size_t k = 0; k < 3; ++k) pull.away[k] += gaussian * away[k];
    });
    return pull;
}

MeshPoint without_normal(const MeshPoint& v, const MeshPoint& normal)
{
    const double along = dot(v, normal);
    return {v[0] - along * normal[0], v[1] - along * normal[1], v[2] - along * normal[2]};
}

std::uint32_t iterations_of(const MeshPointSettings& settings)
{
    return settings.iterations.value_or(usual_iterations(settings.method));
}

}

std::uint32_t usual_iterations(SurfaceMethod method) { return method == SurfaceMethod::lloyd ? 50 : 200; }

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

RelaxedSurface descend_on_surface(const FixedSurface& surface, std::vector<SurfacePoint> points,
                                  const MeshPointSettings& settings, const std::function<void(std::size_t)>& on_step)
{
    const SurfaceMoves moves(surface, settings.normal_angle);
    const double spacing = surface.units_of(std::sqrt(surface.area / static_cast<double>(points.size())));
    const double sigma = settings.sigma * spacing;
    const double usual_length = usual_gaussian_step(settings.sigma, 2) / (settings.sigma * settings.sigma);
    double length = usual_length; // of steps, for a unit of force
    constexpr double widest = std::uint64_t{1} << (contract::surface::COORDINATE_BITS + 1);
    const auto reach = static_cast<std::uint64_t>(std::min(CUT_OFF * sigma, widest)) + 1;
    RelaxedSurface relaxed{std::move(points), {}};
    std::vector<SurfacePoint> kept;
    std::vector<GaussianPull> kept_pulls;
    for (std::size_t step = 0;; ++step) {
        const SurfaceNeighbours near(surface, relaxed.points, reach);
        std::vector<GaussianPull> pulls(relaxed.points.size());
        tbb::parallel_for(std::size_t{0}, pulls.size(), [&](std::size_t i) {
            pulls[i] = pull_at(surface, relaxed.points, near, i, sigma, least_cosine(settings.normal_angle));
        });
        double sum = 0;
        for (const GaussianPull& pull : pulls) sum += pull.sum;
        double energy = gaussian_energy(sum, pulls.size(), settings.sigma, 2);
        if (step > 0 && energy > relaxed.energies.back()) {
            energy = relaxed.energies.back();
            relaxed.points = kept;
            pulls = kept_pulls;
            length /= 2;
        } else {
            kept = relaxed.points;
            kept_pulls = pulls;
            length = std::min(1.25 * length, usual_length);
        }
        relaxed.energies.push_back(energy);
        if (step == iterations_of(settings)) return relaxed;
        if (on_step) on_step(step);
        tbb::parallel_for(std::size_t{0}, pulls.size(), [&](std::size_t i) {
            MeshPoint by = without_normal(pulls[i].away, normal_of(surface.triangles[relaxed.points[i].triangle]));
            for (double& along : by) along *= length;
            relaxed.points[i] = moves.moved(relaxed.points[i], by);
        });
    }
}

}
