// Gaussian blue noise on a surface, see relaxed_surface.hpp.
#include "host/distribution/surfaces/relaxed_surface.hpp"

#include "host/distribution/surfaces/surface_moves.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Lengths in mean distances, the root of the area over the number of points: pairs farther apart have no force, the
/// mean distance that a unit of force moves a point by, and the most that it moves in a step.
constexpr double farthest = 4.5, step = 0.25, longest_move = 0.5;

/// Pieces of the surface that attract points have edges no longer than this part of a mean distance.
constexpr double piece_part = 0.5;

/// The middles of small pieces of a surface, and their areas in mean areas of a point.
struct SurfaceCharges
{
    std::vector<SurfacePoint> places;
    std::vector<double> weights;
};

void add_charges(const FixedSurface& surface, std::uint32_t triangle, double longest, double area,
                 SurfaceCharges& charges)
{
    constexpr double whole = static_cast<double>(std::uint64_t{1} << contract::surface::BARYCENTRIC_BITS);
    const SurfaceTriangle& t = surface.triangles[triangle];
    double edge = 0;
    for (std::size_t a = 0; a < 9; a += 3) {
        const std::size_t b = (a + 3) % 9;
        edge =
            std::max(edge, std::hypot(double(t.corners[a]) - t.corners[b], double(t.corners[a + 1]) - t.corners[b + 1],
                                      double(t.corners[a + 2]) - t.corners[b + 2]));
    }
    const auto parts = std::max<std::int64_t>(1, std::llround(std::ceil(edge / longest)));
    const double side = 1 / static_cast<double>(parts);
    const auto add = [&](double second, double third) {
        SurfacePoint middle{};
        middle.triangle = triangle;
        middle.shares[0] = static_cast<std::uint32_t>(second * side * whole);
        middle.shares[1] = static_cast<std::uint32_t>(third * side * whole);
        std::ranges::copy(place_on(t, middle.shares[0], middle.shares[1]), middle.place);
        charges.places.push_back(middle);
        charges.weights.push_back(surface.areas[triangle] / area * side * side);
    };
    for (std::int64_t i = 0; i < parts; ++i)
        for (std::int64_t j = 0; i + j < parts; ++j) {
            const double u = static_cast<double>(i), v = static_cast<double>(j);
            add(u + 1.0 / 3, v + 1.0 / 3);
            if (i + j + 2 <= parts) add(u + 2.0 / 3, v + 2.0 / 3);
        }
}

/// The force on a point, in its triangle's plane, and its share of the energy.
struct SurfaceForce
{
    MeshPoint force{};
    double energy = 1;
};

class GaussiansOnSurface
{
public:
    GaussiansOnSurface(const FixedSurface& surface, std::size_t points, double normal_angle)
        : surface_(surface), spacing_(surface.units_of(std::sqrt(surface.area / static_cast<double>(points)))),
          least_cosine_(least_cosine(normal_angle)), reach_(static_cast<std::uint64_t>(farthest * spacing_) + 1)
    {
        const double area = surface.area / static_cast<double>(points);
        for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
            add_charges(surface, t, piece_part * spacing_, area, charges_);
    }

    double spacing() const { return spacing_; }

    std::vector<SurfaceForce> on(const std::vector<SurfacePoint>& points) const
    {
        const SurfaceNeighbours near_points(surface_, points, reach_), near_charges(surface_, charges_.places, reach_);
        std::vector<SurfaceForce> forces(points.size());
        tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
            SurfaceForce& force = forces[i];
            near_points.for_each_around(place_of(points[i]), [&](std::uint32_t other) {
                if (other != i) add(points[i], points[other], 1, force);
            });
            near_charges.for_each_around(place_of(points[i]), [&](std::uint32_t other) {
                add(points[i], charges_.places[other], -charges_.weights[other], force);
            });
            const MeshPoint normal = normal_of(surface_.triangles[points[i].triangle]);
            const double upwards = dot(force.force, normal);
            for (std::size_t k = 0; k < 3; ++k) force.force[k] -= upwards * normal[k];
        });
        return forces;
    }

private:
    void add(const SurfacePoint& point, const SurfacePoint& other, double weight, SurfaceForce& force) const
    {
        MeshPoint away{};
        for (std::size_t k = 0; k < 3; ++k)
            away[k] = (static_cast<double>(point.place[k]) - static_cast<double>(other.place[k])) / spacing_;
        const double squared = dot(away, away);
        if (squared > farthest * farthest ||
            cosine_between(surface_.triangles[point.triangle], surface_.triangles[other.triangle]) < least_cosine_)
            return;
        const double gaussian = weight * std::exp(-squared / 2);
        for (std::size_t k = 0; k < 3; ++k) force.force[k] += gaussian * away[k];
        force.energy += gaussian;
    }

    const FixedSurface& surface_;
    double spacing_; ///< in units of the grid
    std::int32_t least_cosine_;
    std::uint64_t reach_;
    SurfaceCharges charges_;
};

}

RelaxedSurface descend_on_surface(const FixedSurface& surface, std::vector<SurfacePoint> points,
                                  const MeshPointSettings& settings, const std::function<void(std::size_t)>& on_step)
{
    const SurfaceMoves moves(surface, settings.normal_angle);
    const GaussiansOnSurface gaussians(surface, points.size(), settings.normal_angle);
    RelaxedSurface relaxed{std::move(points), {}};
    for (std::size_t i = 0;; ++i) {
        const std::vector<SurfaceForce> forces = gaussians.on(relaxed.points);
        double energy = 0;
        for (const SurfaceForce& force : forces) energy += force.energy;
        relaxed.energies.push_back(energy / static_cast<double>(forces.size()));
        if (i == iterations_of(settings)) return relaxed;
        if (on_step) on_step(i);
        tbb::parallel_for(std::size_t{0}, forces.size(), [&](std::size_t p) {
            MeshPoint by = forces[p].force;
            const double length = step * std::sqrt(dot(by, by)),
                         scale = gaussians.spacing() * step * (length > longest_move ? longest_move / length : 1);
            for (double& c : by) c *= scale;
            relaxed.points[p] = moves.moved(relaxed.points[p], by);
        });
    }
}

}
