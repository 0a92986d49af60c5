#include "host/distribution/surfaces/along_surface.hpp"

#include "base/programs/interrupt.hpp"
#include "base/surfaces/surface_paths.hpp"
#include "host/distribution/surfaces/given_points.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "kernels/common/surfaces/surface_elimination.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace poissonlab {
namespace {

using contract::surface::PIECE_COVERED;
using contract::surface::PIECE_OPEN;
using contract::surface::PIECE_SMALL;

double longest_edge_in(const TriangleMesh& mesh)
{
    double squared = 0;
    for (const MeshTriangle& corners : mesh.triangles)
        for (std::size_t c = 0; c < 3; ++c) {
            const MeshPoint edge = difference(mesh.vertices[corners[c]], mesh.vertices[corners[(c + 1) % 3]]);
            squared = std::max(squared, dot(edge, edge));
        }
    return std::sqrt(squared);
}

/// Darts by the lengths of paths, in the order of their numbers.
class PathDarts final : public SurfaceDartEngine
{
public:
    explicit PathDarts(const SurfaceDartRequest& request)
        : surface_(request.surface), stream_(request.stream), mesh_(triangles_of(*surface_)), paths_(mesh_, {})
    {}

    void restart(const contract::surface::SurfaceRule& rule, const std::vector<SurfacePoint>& points,
                 std::size_t) override
    {
        rule_ = path_rule(*surface_, mesh_, rule);
        together_ =
            static_cast<std::size_t>(std::clamp(saturated_count(surface_->area, rule_.distance) / 16, 64.0, 4096.0));
        points_ = points;
    }

    void set_pieces(const std::vector<SurfacePiece>& pieces) override { pieces_ = pieces; }
    void set_choice(const SurfacePieceChoice& choice) override { choice_ = choice; }

    std::vector<SurfacePoint> throw_darts(std::uint64_t first, std::uint32_t darts, std::size_t most) override
    {
        std::vector<SurfacePoint> thrown(darts);
        tbb::parallel_for(std::uint32_t{0}, darts, [&](std::uint32_t i) {
            thrown[i] = reference::surface_dart(*surface_, pieces_, choice_, stream_, first + i);
        });
        std::vector<char> is_rejected = reached_from_points(thrown);
        std::vector<SurfacePoint> accepted;
        for (std::uint32_t next = 0; accepted.size() < most;) {
            std::vector<std::uint32_t> open; // darts whose paths are followed at once
            const std::size_t together = std::min(together_, 2 * std::min(together_, most - accepted.size()) + 8);
            for (; next < darts && open.size() < together; ++next)
                if (!is_rejected[next]) open.push_back(next);
            if (open.empty()) break;
            stop_if_interrupted();
            accept(thrown, open, most, is_rejected, accepted);
        }
        points_.insert(points_.end(), accepted.begin(), accepted.end());
        return accepted;
    }

    std::vector<std::uint32_t> cover() override
    {
        std::vector<PieceDisk> disks(pieces_.size());
        tbb::parallel_for(std::size_t{0}, disks.size(),
                          [&](std::size_t i) { disks[i] = disk_of(*surface_, pieces_[i]); });
        std::vector<SurfacePoint> middles;
        for (const PieceDisk& disk : disks) middles.push_back(disk.middle);
        std::vector<std::uint32_t> states(disks.size(), PIECE_OPEN);
        follow(middles, [&](const SurfacePath& path) {
            note_state(states[path.target],
                       state_by_path(pieces_[path.target], disks[path.target], path.length, rule_));
        });
        return states;
    }

private:
    /// Calls visit(path) for all paths from points to targets that are no longer than the distance, from several
    /// threads.
    template <typename Visit>
    void follow(const std::vector<SurfacePoint>& targets, const Visit& visit)
    {
        paths_.aim_at(positions_of(targets));
        const double units = surface_->units_of(rule_.distance) + static_cast<double>(contract::surface::SLACK);
        const SurfaceNeighbours near(*surface_, targets, static_cast<std::uint64_t>(units) + 1);
        const auto squared = static_cast<std::uint64_t>(units * units);
        std::vector<char> is_near(points_.size());
        tbb::parallel_for(std::size_t{0}, points_.size(),
                          [&](std::size_t i) { is_near[i] = near.is_near(points_[i], squared, least_cosine(180)); });
        std::vector<SurfacePoint> sources; // paths are no shorter than straight lines
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (is_near[i]) sources.push_back(points_[i]);
        paths_.from_each(positions_of(sources), rule_.distance, [&](std::size_t, std::span<const SurfacePath> paths) {
            for (const SurfacePath& path : paths) visit(path);
        });
    }

    std::vector<char> reached_from_points(const std::vector<SurfacePoint>& thrown)
    {
        std::vector<char> reached(thrown.size());
        follow(thrown, [&](const SurfacePath& path) {
            if (path.length < rule_.distance)
                std::atomic_ref<char>(reached[path.target]).store(1, std::memory_order_relaxed);
        });
        return reached;
    }

    /// Accepts those of the open darts, in order, that no accepted one reaches, and rejects what these reach. Paths
    /// lead to all thrown darts.
    void accept(const std::vector<SurfacePoint>& thrown, const std::vector<std::uint32_t>& open, std::size_t most,
                std::vector<char>& is_rejected, std::vector<SurfacePoint>& accepted) const
    {
        std::vector<SurfacePoint> sources;
        for (const std::uint32_t i : open) sources.push_back(thrown[i]);
        std::vector<std::vector<std::uint32_t>> reached(open.size());
        paths_.from_each(positions_of(sources), rule_.distance, [&](std::size_t i, std::span<const SurfacePath> paths) {
            for (const SurfacePath& path : paths)
                if (path.target > open[i] && path.length < rule_.distance) reached[i].push_back(path.target);
        });
        for (std::size_t i = 0; i < open.size() && accepted.size() < most; ++i) {
            if (is_rejected[open[i]]) continue;
            accepted.push_back(sources[i]);
            for (const std::uint32_t other : reached[i]) is_rejected[other] = 1;
        }
    }

    std::shared_ptr<const FixedSurface> surface_;
    StreamKey stream_;
    TriangleMesh mesh_;
    SurfacePaths paths_;
    PathRule rule_;
    std::size_t together_ = 0; ///< darts whose paths are followed at once
    std::vector<SurfacePiece> pieces_;
    SurfacePieceChoice choice_;
    std::vector<SurfacePoint> points_;
};

}

PathRule path_rule(const FixedSurface& surface, const TriangleMesh& mesh, const contract::surface::SurfaceRule& rule)
{
    const double moved = 4e-9 * longest_edge_in(mesh);
    return {std::sqrt(static_cast<double>(rule.squared)) * surface.unit * (1 + path_rounding) + moved,
            std::sqrt(static_cast<double>(rule.covered)) * surface.unit * (1 - path_rounding) - moved};
}

PieceDisk disk_of(const FixedSurface& surface, const SurfacePiece& piece)
{
    PieceDisk disk;
    disk.middle.triangle = piece.triangle;
    for (std::size_t k = 0; k < 2; ++k)
        disk.middle.shares[k] = static_cast<std::uint32_t>(
            (std::uint64_t{piece.shares[k]} + piece.shares[2 + k] + piece.shares[4 + k]) / 3);
    const SurfaceTriangle& triangle = surface.triangles[piece.triangle];
    const MeshPlace middle = place_on(triangle, disk.middle.shares[0], disk.middle.shares[1]);
    std::ranges::copy(middle, disk.middle.place);
    for (std::size_t c = 0; c < 6; c += 2) {
        const MeshPlace corner = place_on(triangle, piece.shares[c], piece.shares[c + 1]);
        disk.radius = std::max(disk.radius, std::sqrt(static_cast<double>(squared_distance(middle, corner))));
    }
    disk.radius = (disk.radius + static_cast<double>(contract::surface::SLACK)) * surface.unit;
    return disk;
}

std::uint32_t state_by_path(const SurfacePiece& piece, const PieceDisk& disk, double length, const PathRule& rule)
{
    if (length + disk.radius < rule.sure) return PIECE_COVERED;
    return is_last(piece) && length < rule.distance ? PIECE_SMALL : PIECE_OPEN;
}

void note_state(std::uint32_t& piece, std::uint32_t found)
{
    const std::atomic_ref<std::uint32_t> state(piece);
    if (found == PIECE_COVERED) state.store(found, std::memory_order_relaxed);
    if (std::uint32_t open = PIECE_OPEN; found == PIECE_SMALL)
        state.compare_exchange_strong(open, found, std::memory_order_relaxed);
}

std::vector<MeshPosition> positions_of(const std::vector<SurfacePoint>& points)
{
    std::vector<MeshPosition> positions;
    for (const SurfacePoint& p : points) positions.push_back({p.triangle, barycentrics_of(p)});
    return positions;
}

std::unique_ptr<SurfaceDartEngine> path_dart_engine(const SurfaceDartRequest& request)
{
    return std::make_unique<PathDarts>(request);
}

std::vector<std::uint32_t> removal_order_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                               const SurfaceReach& reach, std::size_t count)
{
    const TriangleMesh mesh = triangles_of(surface);
    const std::vector<MeshPosition> positions = positions_of(points);
    std::vector<std::vector<reference::Partner>> later(points.size()); // so that a pair has one weight
    SurfacePaths(mesh, positions)
        .from_each(positions, reach.most, [&](std::size_t i, std::span<const SurfacePath> paths) {
            for (const SurfacePath& path : paths) {
                if (path.target <= i || path.length >= reach.most) continue;
                const double rest = 1 - std::max(path.length, reach.least) / reach.most,
                             fourth = (rest * rest) * (rest * rest);
                later[i].push_back(
                    {path.target,
                     static_cast<std::uint64_t>(fourth * fourth * contract::surface_elimination::WEIGHT_UNITS + 0.5)});
            }
        });
    std::vector<std::vector<reference::Partner>> partners = later;
    for (std::uint32_t i = 0; i < later.size(); ++i)
        for (const auto& [other, weight] : later[i]) partners[other].push_back({i, weight});
    return reference::heaviest_first(partners, count, {});
}

PathDistances distances_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points)
{
    return distances_along(surface, points, points);
}

PathDistances distances_along(const FixedSurface& surface, const std::vector<SurfacePoint>& from,
                              const std::vector<SurfacePoint>& to)
{
    PathDistances distances{INFINITY, 0};
    if (from.empty() || to.empty()) return distances;
    const TriangleMesh mesh = triangles_of(surface);
    const std::vector<MeshPosition> positions = positions_of(from);
    const SurfacePaths paths(mesh, positions_of(to));
    const bool are_same = &from == &to;
    std::vector<double> nearest(from.size(), INFINITY);
    const double spacing = std::sqrt(surface.area / static_cast<double>(to.size()));
    std::vector<std::uint32_t> alone(from.size());
    for (std::uint32_t i = 0; i < alone.size(); ++i) alone[i] = i;
    for (double reach = spacing; reach <= 16 * spacing && !alone.empty(); reach *= 2) {
        std::vector<MeshPosition> sources;
        for (const std::uint32_t i : alone) sources.push_back(positions[i]);
        paths.from_each(sources, reach, [&](std::size_t i, std::span<const SurfacePath> found) {
            for (const SurfacePath& path : found)
                if (!are_same || path.target != alone[i]) nearest[alone[i]] = std::min(nearest[alone[i]], path.length);
        });
        std::erase_if(alone, [&](std::uint32_t i) { return std::isfinite(nearest[i]); });
    }
    for (const double length : nearest)
        if (std::isfinite(length)) {
            distances.least = std::min(distances.least, length);
            distances.mean_nearest += length / static_cast<double>(from.size() - alone.size());
        }
    return distances;
}

bool keep_distance_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points, double distance,
                         std::size_t first)
{
    const TriangleMesh mesh = triangles_of(surface);
    const std::vector<MeshPosition> positions = positions_of(points);
    std::atomic<bool> is_kept = true;
    SurfacePaths(mesh, positions)
        .from_each({positions.begin() + static_cast<std::ptrdiff_t>(first), positions.end()},
                   distance * (1 - path_rounding), [&](std::size_t i, std::span<const SurfacePath> paths) {
                       if (std::ranges::any_of(paths, [&](const SurfacePath& p) { return p.target != first + i; }))
                           is_kept = false;
                   });
    return is_kept;
}

std::size_t uncovered_along(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                            const std::vector<SurfacePoint>& places, double distance)
{
    const TriangleMesh mesh = triangles_of(surface);
    std::vector<char> is_covered(places.size());
    SurfacePaths(mesh, positions_of(places))
        .from_each(positions_of(points), distance, [&](std::size_t, std::span<const SurfacePath> paths) {
            for (const SurfacePath& path : paths)
                std::atomic_ref<char>(is_covered[path.target]).store(1, std::memory_order_relaxed);
        });
    return static_cast<std::size_t>(std::ranges::count(is_covered, 0));
}

}
