// Slots are settled in groups. Each slot of a group has a candidate: its first dart that no point reaches. Candidates
// become points in the order of their slots; one that a point of an earlier slot reaches gives way to the next dart of
// its slot. Slots so get the darts that they would get one after the other, whatever the size of groups.
#include "host/distribution/surface_classes/path_class_darts.hpp"

#include "base/programs/interrupt.hpp"
#include "base/surfaces/surface_paths.hpp"
#include "host/distribution/surfaces/along_surface.hpp"
#include "host/distribution/surfaces/given_points.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

namespace poissonlab {
namespace {

using contract::class_surface::SurfaceSlot;
using contract::class_surface::TRIES;

constexpr std::uint32_t first_darts = 2, most_darts = 64; ///< that a slot draws at once

/// A slot that has no point yet.
struct OpenSlot
{
    std::uint32_t at = 0;   ///< the number of its point
    std::uint32_t own = 0;  ///< its class
    std::uint32_t next = 0; ///< the first of its darts that was not looked at
    std::uint32_t end = 0;  ///< that of those which it does not have
    std::uint32_t drawn = first_darts;
    std::optional<SurfacePoint> candidate{};

    bool is_lost() const { return !candidate && next == end; }
};

class PathClassDarts final : public ClassSurfaceEngine
{
public:
    explicit PathClassDarts(const ClassSurfaceRequest& request)
        : surface_(request.surface), stream_(request.stream), classes_(request.distances.classes()),
          mesh_(triangles_of(*surface_)), paths_(mesh_, {}), points_(classes_)
    {}

    void restart(const ClassSurfaceRules& rules, const ClassSurfaceDarts& darts, std::size_t) override
    {
        rules_.clear();
        for (const contract::surface::SurfaceRule& rule : rules) rules_.push_back(path_rule(*surface_, mesh_, rule));
        double least = INFINITY;
        reach_.assign(classes_, 0);
        for (std::size_t own = 0; own < classes_; ++own) {
            least = std::min(least, rule(own, own).distance);
            for (std::size_t other = 0; other < classes_; ++other)
                reach_[other] = std::max(reach_[other], rule(own, other).distance);
        }
        together_ = static_cast<std::size_t>(std::clamp(saturated_count(surface_->area, least) / 16, 16.0, 4096.0));
        for (std::uint32_t own = 0; own < classes_; ++own) points_[own] = darts.of_class(own);
    }

    void set_pieces(const std::vector<ClassPieces>& all, std::size_t) override { open_ = &all; }

    Settled settle(const std::vector<SurfaceSlot>& slots, std::size_t first, std::uint32_t skipped) override
    {
        Settled settled;
        for (std::size_t begin = 0; begin < slots.size();) {
            const std::size_t end = std::min(slots.size(), begin + together_);
            std::vector<OpenSlot> group;
            for (std::size_t i = begin; i < end; ++i) {
                const std::uint32_t from = i == 0 ? skipped : 0;
                group.push_back({static_cast<std::uint32_t>(first + i), slots[i].own, from, from + TRIES});
            }
            if (!settle(slots, first, group, settled)) break;
            begin = end;
        }
        return settled;
    }

    std::vector<std::uint32_t> cover(std::uint32_t own) override
    {
        const std::vector<SurfacePiece>& pieces = (*open_)[own].pieces;
        std::vector<PieceDisk> disks(pieces.size());
        tbb::parallel_for(std::size_t{0}, disks.size(),
                          [&](std::size_t i) { disks[i] = disk_of(*surface_, pieces[i]); });
        std::vector<SurfacePoint> middles;
        for (const PieceDisk& disk : disks) middles.push_back(disk.middle);
        std::vector<std::uint32_t> states(disks.size(), contract::surface::PIECE_OPEN);
        follow(middles, [&](std::size_t other, const SurfacePath& path) {
            const std::size_t i = path.target;
            note_state(states[i], state_by_path(pieces[i], disks[i], path.length, rule(own, other)));
        });
        return states;
    }

private:
    const PathRule& rule(std::size_t own, std::size_t other) const { return rules_[own * classes_ + other]; }

    /// Calls visit(class of the point, path) for all paths from points to targets that may matter, from several
    /// threads.
    template <typename Visit>
    void follow(const std::vector<SurfacePoint>& targets, const Visit& visit)
    {
        paths_.aim_at(positions_of(targets));
        for (std::size_t own = 0; own < classes_; ++own) {
            const double units = surface_->units_of(reach_[own]) + static_cast<double>(contract::surface::SLACK);
            const SurfaceNeighbours near(*surface_, targets, static_cast<std::uint64_t>(units) + 1);
            const auto squared = static_cast<std::uint64_t>(units * units);
            const std::vector<SurfacePoint>& points = points_[own];
            std::vector<char> is_near(points.size());
            tbb::parallel_for(std::size_t{0}, points.size(),
                              [&](std::size_t i) { is_near[i] = near.is_near(points[i], squared, least_cosine(180)); });
            std::vector<SurfacePoint> sources; // paths are no shorter than straight lines
            for (std::size_t i = 0; i < points.size(); ++i)
                if (is_near[i]) sources.push_back(points[i]);
            paths_.from_each(positions_of(sources), reach_[own], [&](std::size_t, std::span<const SurfacePath> paths) {
                for (const SurfacePath& path : paths) visit(own, path);
            });
        }
    }

    /// Settles the slots of a group, in order. Returns false at one all of whose darts failed.
    bool settle(const std::vector<SurfaceSlot>& slots, std::size_t first, std::vector<OpenSlot>& group,
                Settled& settled)
    {
        while (!group.empty()) {
            stop_if_interrupted();
            find_candidates(slots, first, group);
            if (group.front().is_lost()) return false;
            const std::size_t before = settled.points.size();
            accept(group, settled);
            group.erase(group.begin(), group.begin() + static_cast<std::ptrdiff_t>(settled.points.size() - before));
        }
        return true;
    }

    /// Draws darts until each slot has a candidate or has lost. Slots behind one that has lost do not matter.
    void find_candidates(const std::vector<SurfaceSlot>& slots, std::size_t first, std::vector<OpenSlot>& group)
    {
        for (;;) {
            std::vector<std::size_t> seeking, owners;
            std::vector<SurfacePoint> darts;
            for (std::size_t i = 0; i < group.size() && !group[i].is_lost(); ++i)
                if (!group[i].candidate) seeking.push_back(i);
            if (seeking.empty()) return;
            for (const std::size_t i : seeking) {
                const OpenSlot& slot = group[i];
                const std::uint32_t end = std::min(slot.end, slot.next + slot.drawn);
                for (std::uint32_t number = slot.next; number < end; ++number) {
                    darts.push_back(reference::class_surface_dart(*surface_, (*open_)[slot.own], slots[slot.at - first],
                                                                  slot.at, number, stream_));
                    owners.push_back(i);
                }
            }
            std::vector<char> reached(darts.size());
            follow(darts, [&](std::size_t other, const SurfacePath& path) {
                if (path.length < rule(group[owners[path.target]].own, other).distance)
                    std::atomic_ref<char>(reached[path.target]).store(1, std::memory_order_relaxed);
            });
            for (std::size_t k = 0; k < darts.size(); ++k) {
                OpenSlot& slot = group[owners[k]];
                if (slot.candidate) continue;
                ++slot.next;
                if (!reached[k]) slot.candidate = darts[k];
            }
            for (const std::size_t i : seeking) group[i].drawn = std::min(most_darts, 2 * group[i].drawn);
        }
    }

    /// Makes points of the candidates, in order, up to a slot that has none any more.
    void accept(std::vector<OpenSlot>& group, Settled& settled)
    {
        std::vector<SurfacePoint> candidates;
        std::size_t count = 0; // of slots up to the first one without
        while (count < group.size() && group[count].candidate) candidates.push_back(*group[count++].candidate);
        const std::vector<MeshPosition> positions = positions_of(candidates);
        paths_.aim_at(positions);
        std::vector<std::vector<SurfacePath>> reached(count);
        paths_.from_each(
            positions, *std::ranges::max_element(reach_), [&](std::size_t i, std::span<const SurfacePath> paths) {
                for (const SurfacePath& path : paths)
                    if (path.target > i && path.length < rule(group[path.target].own, group[i].own).distance)
                        reached[i].push_back(path);
            });
        for (std::size_t i = 0; i < count && group[i].candidate; ++i) {
            points_[group[i].own].push_back(candidates[i]);
            settled.points.push_back(candidates[i]);
            for (const SurfacePath& path : reached[i]) {
                settled.redrawn += group[path.target].candidate ? 1 : 0;
                group[path.target].candidate.reset();
            }
        }
    }

    std::shared_ptr<const FixedSurface> surface_;
    StreamKey stream_;
    std::size_t classes_;
    TriangleMesh mesh_;
    SurfacePaths paths_;
    std::vector<PathRule> rules_;                   ///< of each class of darts, a row: those of classes of points
    std::vector<double> reach_;                     ///< of points of each class: the longest path that matters
    std::size_t together_ = 0;                      ///< slots that are settled at once
    std::vector<std::vector<SurfacePoint>> points_; ///< of each class
    const std::vector<ClassPieces>* open_ = nullptr;
};

}

std::unique_ptr<ClassSurfaceEngine> path_class_engine(const ClassSurfaceRequest& request)
{
    return std::make_unique<PathClassDarts>(request);
}

std::vector<SurfacePair> pairs_along(const FixedSurface& surface,
                                     const std::vector<std::vector<SurfacePoint>>& by_class)
{
    const auto nearest = [&](std::size_t from, std::size_t to) {
        const PathDistances found = distances_along(surface, by_class[from], by_class[to]);
        return SurfaceNearest{found.least, std::isfinite(found.least) ? found.mean_nearest : NAN};
    };
    std::vector<SurfacePair> pairs;
    for (std::size_t i = 0; i < by_class.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const SurfaceNearest there = nearest(j, i);
            pairs.push_back({j, i, there, i == j ? there : nearest(i, j)});
        }
    return pairs;
}

}
