// Gaussian blue noise on a surface, see relaxed_surface.hpp.
#include "host/distribution/surfaces/relaxed_surface.hpp"

#include "host/distribution/surfaces/surface_moves.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

/// Lengths in mean distances, the root of the area over the number of points: pairs farther apart have no force, the
/// mean distance that a unit of force moves a point by, and the most that it moves in a step.
constexpr double farthest = 4.5, step = 0.25, longest_move = 0.5;

/// Pieces of the surface that attract points are no larger than this part of a point's area. Narrow ones are no longer
/// than a mean distance either, unless their area is next to none.
constexpr double piece_part = 0.125, longest_piece = 1, narrow_part = 1.0 / 512;

/// The middles of small pieces of a surface, and their areas in mean areas of a point.
struct SurfaceCharges
{
    std::vector<SurfacePoint> places;
    std::vector<double> weights;
};

/// The longest edge of a triangle with these corners, in units of the grid.
double longest_edge_of(const std::array<MeshPlace, 3>& corners)
{
    std::uint64_t squared = 0;
    for (std::size_t c = 0; c < 3; ++c) squared = std::max(squared, squared_distance(corners[c], corners[(c + 1) % 3]));
    return std::sqrt(static_cast<double>(squared));
}

bool is_small_enough(const FixedSurface& surface, const SurfacePiece& piece, double area)
{
    const double own = area_of(surface, piece);
    if (own > piece_part * area) return false;
    if (own <= narrow_part * area) return true;
    std::array<MeshPlace, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c)
        corners[c] = place_on(surface.triangles[piece.triangle], piece.shares[2 * c], piece.shares[2 * c + 1]);
    return longest_edge_of(corners) <= longest_piece * surface.units_of(std::sqrt(area));
}

/// The charges of a surface where points have this area. Halves of longest edges make few pieces of long triangles.
SurfaceCharges charges_of(const FixedSurface& surface, double area)
{
    std::vector<SurfacePiece> pieces = whole_pieces(surface);
    for (bool is_finer = true; is_finer;) {
        tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
            if (!is_last(pieces[i]) && is_small_enough(surface, pieces[i], area)) pieces[i].halvings |= LAST_PIECE;
        });
        RefinedPieces halved =
            refined(surface, pieces, std::vector<std::uint32_t>(pieces.size(), contract::surface::PIECE_OPEN));
        pieces = std::move(halved.pieces);
        is_finer = halved.is_finer;
    }
    SurfaceCharges charges;
    for (const SurfacePiece& piece : pieces) {
        SurfacePoint& middle = charges.places.emplace_back();
        middle.triangle = piece.triangle;
        for (std::size_t k = 0; k < 2; ++k)
            middle.shares[k] = static_cast<std::uint32_t>(
                (std::uint64_t{piece.shares[k]} + piece.shares[2 + k] + piece.shares[4 + k]) / 3);
        std::ranges::copy(place_on(surface.triangles[piece.triangle], middle.shares[0], middle.shares[1]),
                          middle.place);
        charges.weights.push_back(area_of(surface, piece) / area);
    }
    return charges;
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
          least_cosine_(least_cosine(normal_angle)), reach_(static_cast<std::uint64_t>(farthest * spacing_) + 1),
          charges_(charges_of(surface, surface.area / static_cast<double>(points))),
          near_charges_(surface, charges_.places, reach_)
    {}

    double spacing() const { return spacing_; }

    std::vector<SurfaceForce> on(const std::vector<SurfacePoint>& points) const
    {
        const SurfaceNeighbours near_points(surface_, points, reach_);
        std::vector<SurfaceForce> forces(points.size());
        tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
            SurfaceForce& force = forces[i];
            near_points.for_each_around(place_of(points[i]), [&](std::uint32_t other) {
                if (other != i) add(points[i], points[other], 1, force);
            });
            near_charges_.for_each_around(place_of(points[i]), [&](std::uint32_t other) {
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
    SurfaceNeighbours near_charges_;
};

}

double gaussian_charges(const FixedSurface& surface, double points)
{
    const double area = surface.area / points, spacing = surface.units_of(std::sqrt(area));
    double charges = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        std::array<MeshPlace, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t k = 0; k < 3; ++k) corners[c][k] = surface.triangles[t].corners[3 * c + k];
        const double own = surface.areas[t] / area, length = longest_edge_of(corners) / (longest_piece * spacing);
        charges += 1 + 2 / piece_part * own + std::min(2 / narrow_part * own, 2 * length);
    }
    return charges;
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
