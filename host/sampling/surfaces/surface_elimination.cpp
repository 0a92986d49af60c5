// Runs kernels/surfaces/surface_elimination.cl, and the order of points from one elimination after the other.
#include "host/sampling/surfaces/surface_elimination.hpp"

#include "base/geometry/torus.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace poissonlab {

using contract::surface_elimination::Candidate;
using contract::surface_elimination::Elimination;

struct SurfaceEliminationBuffers
{
    Buffer<SurfaceTriangle> triangles;
    Buffer<Candidate> candidates; ///< by buckets
    Buffer<std::uint32_t> ids;    ///< their numbers
    Buffer<std::uint32_t> starts; ///< of buckets
    Buffer<std::int64_t> weights; ///< of removed points: one's complement of what they were
    Buffer<std::uint32_t> heavier, marks, touched;
    Buffer<std::uint32_t> removed; ///< of a round

    NeededBuffers needed(std::size_t points)
    {
        return {{candidates, points}, {ids, points},     {starts, surface_bucket_count(points) + 1},
                {weights, points},    {heavier, points}, {marks, points},
                {touched, points},    {removed, 1}};
    }
};

namespace {

/// Each time that all points of a weight or more are gone, and more have to go, this part of it is the next.
constexpr std::int64_t next_weight_part = 2;

double packed_on_surface(const FixedSurface& surface, std::size_t points)
{
    return std::sqrt(2 / std::numbers::sqrt3 * surface.area / static_cast<double>(points));
}

/// The numbers of points that are not among the removed ones, ascending.
std::vector<std::uint32_t> rest_of(const std::vector<std::uint32_t>& removed, std::size_t points)
{
    std::vector<bool> is_removed(points);
    for (const std::uint32_t number : removed) is_removed[number] = true;
    std::vector<std::uint32_t> rest;
    for (std::uint32_t i = 0; i < points; ++i)
        if (!is_removed[i]) rest.push_back(i);
    return rest;
}

template <typename T>
std::vector<T> chosen_of(const std::vector<T>& all, const std::vector<std::uint32_t>& numbers)
{
    std::vector<T> chosen;
    chosen.reserve(numbers.size());
    for (const std::uint32_t number : numbers) chosen.push_back(all[number]);
    return chosen;
}

/// The elimination of one set.
class SurfaceEliminationRun
{
public:
    SurfaceEliminationRun(Device& device, SurfaceEliminationBuffers& buffers, const FixedSurface& surface,
                          const std::vector<SurfacePoint>& points, const SurfaceReach& reach, std::size_t group_size)
        : buffers_(buffers), elimination_(surface_elimination(surface, reach, points.size())), group_size_(group_size)
    {
        const KernelProgram program = kernel_program("surfaces/surface_elimination.cl", {});
        mark_ = device.kernel(program, "mark_heaviest");
        touch_ = device.kernel(program, "touch_around");
        remove_ = device.kernel(program, "remove_marked");
        reserve(device, buffers.needed(points.size()));
        elimination_.bucket_mask = static_cast<std::uint32_t>(surface_bucket_count(points.size()) - 1);
        SurfaceBucketOrder order = surface_bucket_order(points, elimination_.cell, elimination_.bucket_mask);
        std::vector<Candidate> sorted;
        sorted.reserve(points.size());
        for (const std::uint32_t id : order.ids) {
            const SurfacePoint& p = points[id];
            sorted.push_back({.place = {p.place[0], p.place[1], p.place[2]}, .triangle = p.triangle});
        }
        buffers.candidates.write(sorted);
        buffers.ids.write(order.ids);
        buffers.starts.write(order.starts);
        ids_ = std::move(order.ids);
        device.kernel(program, "weigh_candidates")
            .run(ids_.size(), group_size_, elimination_, buffers.candidates, buffers.triangles, buffers.starts,
                 buffers.weights, buffers.heavier, buffers.marks, buffers.touched);
    }

    std::vector<std::uint32_t> first(std::size_t count)
    {
        std::int64_t least = first_least(count);
        for (std::size_t removed = remove_down_to(least); removed < count; removed += remove_down_to(least))
            least /= next_weight_part;
        return heaviest_removed(buffers_.weights.read(0, ids_.size()), ids_, count);
    }

private:
    /// Points that are removed while the heaviest ones go have at most the weight that so many points have at first.
    std::int64_t first_least(std::size_t count) const
    {
        std::vector<std::int64_t> weights = buffers_.weights.read(0, ids_.size());
        const auto least = weights.begin() + static_cast<std::ptrdiff_t>(count);
        std::ranges::nth_element(weights, least, std::greater{});
        return *least;
    }

    /// Removes points until all are lighter; the number of those removed.
    std::size_t remove_down_to(std::int64_t least)
    {
        SurfaceEliminationBuffers& b = buffers_;
        std::size_t removed = 0;
        for (std::uint32_t of_round = 1; of_round > 0; removed += of_round) {
            b.removed.write(std::vector<std::uint32_t>(1));
            mark_.run(ids_.size(), group_size_, elimination_, least, b.candidates, b.triangles, b.starts, b.ids,
                      b.weights, b.heavier, b.marks, b.removed);
            touch_.run(ids_.size(), group_size_, elimination_, b.candidates, b.triangles, b.starts, b.weights, b.marks,
                       b.touched);
            remove_.run(ids_.size(), group_size_, elimination_, b.candidates, b.triangles, b.starts, b.weights, b.marks,
                        b.touched);
            of_round = b.removed.read(0, 1).front();
        }
        return removed;
    }

    SurfaceEliminationBuffers& buffers_;
    Elimination elimination_;
    std::size_t group_size_;
    std::vector<std::uint32_t> ids_;
    Kernel mark_, touch_, remove_;
};

}

std::vector<SurfacePoint> surface_candidates(const FixedSurface& surface, std::size_t count, const StreamKey& stream)
{
    const std::vector<SurfacePiece> pieces = whole_pieces(surface);
    const SurfacePieceChoice choice = surface_piece_choice(surface, pieces);
    std::vector<SurfacePoint> candidates;
    candidates.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        candidates.push_back(reference::surface_dart(surface, pieces, choice, stream, i));
    return candidates;
}

std::vector<SurfacePoint> eliminate_on_surface(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                               std::size_t kept, double angle, const SurfaceRemovalOrder& removal_order)
{
    std::vector<SurfacePoint> left = points;
    if (kept < points.size()) {
        const double most = packed_on_surface(surface, kept);
        const double share = static_cast<double>(kept) / static_cast<double>(points.size());
        const SurfaceReach reach{most, most * (1 - share * std::sqrt(share)) * 0.65, angle};
        left = chosen_of(points, rest_of(removal_order(points, reach, points.size() - kept), points.size()));
    }
    std::vector<SurfacePoint> ordered = left;
    while (left.size() >= 3) {
        const std::size_t half = left.size() / 2;
        const auto removed = removal_order(left, {packed_on_surface(surface, half), 0, angle}, left.size() - half);
        for (std::size_t i = 0; i < removed.size(); ++i) ordered[left.size() - 1 - i] = left[removed[i]];
        left = chosen_of(left, rest_of(removed, left.size()));
        std::ranges::copy(left, ordered.begin());
    }
    return ordered;
}

Elimination surface_elimination(const FixedSurface& surface, const SurfaceReach& reach, std::size_t points)
{
    const double units = surface.units_of(reach.most);
    // The corners of the grid are farther apart than any two points.
    const double widest = std::ldexp(std::numbers::sqrt3, contract::surface::COORDINATE_BITS);
    return {.squared_reach = squared_threshold(std::min(units * 0x1p-32, 1.0)),
            .reach = units,
            .least = surface.units_of(reach.least),
            .least_cosine = least_cosine(reach.angle),
            .cell = static_cast<std::uint32_t>(std::floor(2 * std::min(units, widest))) + 2,
            .bucket_mask = 0,
            .points = static_cast<std::uint32_t>(points)};
}

SurfaceElimination::SurfaceElimination(Device device, std::shared_ptr<const FixedSurface> surface,
                                       std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<SurfaceEliminationBuffers>()),
      surface_(std::move(surface))
{
    reserve(device_, buffers_->triangles, surface_->triangles.size());
    buffers_->triangles.write(surface_->triangles);
}

std::vector<std::uint32_t> SurfaceElimination::removal_order(const std::vector<SurfacePoint>& points,
                                                             const SurfaceReach& reach, std::size_t count)
{
    return SurfaceEliminationRun(device_, *buffers_, *surface_, points, reach, work_group_size_).first(count);
}

DeviceMemory SurfaceElimination::memory(const FixedSurface& surface, std::size_t points)
{
    return memory_of(SurfaceEliminationBuffers{}.needed(points))
        .add(surface.triangles.size() * sizeof(SurfaceTriangle));
}

}
