// Runs kernels/surfaces/class_surface_darts.cl.
#include "host/device/needed_buffers.hpp"
#include "host/sampling/surfaces/class_surface_darts.hpp"

#include <algorithm>
#include <array>

namespace poissonlab {
namespace {

using contract::class_surface::COUNTERS;
using contract::class_surface::OpenPieces;
using contract::class_surface::REDRAWN;
using contract::class_surface::SETTLED;
using contract::class_surface::SurfaceSlot;
using contract::class_surface::SurfaceSlots;

struct ClassSurfaceBuffers
{
    using Words = Buffer<std::uint32_t>;

    Buffer<SurfaceTriangle> triangles;
    Buffer<contract::surface::SurfaceRule> rules;
    Buffer<OpenPieces> lists;
    Buffer<SurfacePiece> pieces;
    Buffer<std::uint64_t> ends;
    Words guide, states, heads, counters;
    Buffer<SurfaceSlot> slots;
    Buffer<SurfacePoint> points, candidates;
};

/// Pieces for each point that there are at most, about.
constexpr std::size_t pieces_a_point = 6;

NeededBuffers buffers_for(ClassSurfaceBuffers& b, std::size_t classes, std::size_t capacity, std::size_t buckets)
{
    return {{b.rules, classes * classes},
            {b.lists, classes},
            {b.heads, buckets},
            {b.points, capacity},
            {b.candidates, most_surface_slots},
            {b.slots, most_surface_slots},
            {b.counters, COUNTERS}};
}

NeededBuffers buffers_of_lists(ClassSurfaceBuffers& b, std::size_t pieces, std::size_t guide)
{
    return {{b.pieces, pieces}, {b.ends, pieces}, {b.guide, guide}, {b.states, pieces}};
}

std::uint32_t word(std::size_t value) { return static_cast<std::uint32_t>(value); }

class KernelClassSurface final : public ClassSurfaceEngine, DeviceMethod<ClassSurfaceBuffers>
{
public:
    KernelClassSurface(const ClassSurfaceRequest& request, const Device& device, std::size_t work_group_size)
        : DeviceMethod(device, work_group_size, std::make_shared<ClassSurfaceBuffers>()), surface_(request.surface),
          stream_(request.stream), lists_(request.distances.classes()), rooms_(lists_.size())
    {
        const KernelProgram program = kernel_program("surfaces/class_surface_darts.cl", {});
        find_ = device_.kernel(program, "find_class_darts");
        settle_ = device_.kernel(program, "settle_class_darts");
        cover_ = device_.kernel(program, "cover_class_pieces");
        reserve(device_, buffers_->triangles, surface_->triangles.size());
        buffers_->triangles.write(surface_->triangles);
    }

    /// Chains go from the last point to the first, as settled points come.
    void restart(const ClassSurfaceRules& rules, const ClassSurfaceDarts& darts, std::size_t capacity) override
    {
        const std::size_t classes = lists_.size();
        std::size_t buckets = 0;
        for (std::size_t i = 0; i < classes; ++i) buckets += rules[i].bucket_mask + std::size_t{1};
        reserve(device_, buffers_for(*buffers_, classes, capacity, buckets));
        std::vector<std::uint32_t> heads(buckets);
        std::vector<SurfacePoint> points = darts.points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto& rule = rules[darts.classes[i]];
            std::uint32_t& head = heads[rule.first + surface_bucket(points[i], rule.cell, rule.bucket_mask)];
            points[i].next = head;
            head = word(i + 1);
        }
        buffers_->rules.write(rules);
        buffers_->heads.write(heads);
        if (!points.empty()) buffers_->points.write(points);
    }

    void set_pieces(const std::vector<ClassPieces>& all, std::size_t own) override
    {
        if (fits(all[own], own)) return write_list(all[own], own);
        // Every list gets some room to grow.
        std::size_t pieces = 0, guide = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            rooms_[i].pieces = std::max(rooms_[i].pieces, all[i].pieces.size() * 3 / 2);
            rooms_[i].guide = std::max(rooms_[i].guide, surface_guide_size(rooms_[i].pieces));
            lists_[i].first = word(pieces);
            lists_[i].first_guide = word(guide);
            pieces += rooms_[i].pieces;
            guide += rooms_[i].guide;
        }
        reserve(device_, buffers_of_lists(*buffers_, pieces, guide));
        for (std::size_t i = 0; i < all.size(); ++i) write_list(all[i], i);
    }

    Settled settle(const std::vector<SurfaceSlot>& slots, std::size_t first, std::uint32_t skipped) override
    {
        ClassSurfaceBuffers& b = *buffers_;
        const SurfaceSlots batch{.classes = word(lists_.size()),
                                 .first = word(first),
                                 .slots = word(slots.size()),
                                 .skipped = skipped,
                                 .key_x = stream_[0],
                                 .key_y = stream_[1]};
        b.slots.write(slots);
        b.lists.write(lists_);
        find_.run(slots.size(), work_group_size_, batch, b.slots, b.rules, b.lists, b.triangles, b.pieces, b.ends,
                  b.guide, b.heads, b.points, b.candidates);
        settle_.run(1, 1, batch, b.slots, b.rules, b.lists, b.triangles, b.pieces, b.ends, b.guide, b.heads, b.points,
                    b.candidates, b.counters);
        std::array<std::uint32_t, COUNTERS> counters{};
        b.counters.read(counters);
        Settled settled{{}, counters[REDRAWN]};
        if (counters[SETTLED] > 0) settled.points = b.points.read(first, counters[SETTLED]);
        for (SurfacePoint& point : settled.points) point.next = 0;
        return settled;
    }

    std::vector<std::uint32_t> cover(std::uint32_t own) override
    {
        ClassSurfaceBuffers& b = *buffers_;
        cover_.run(lists_[own].count, work_group_size_, word(lists_.size()), own, lists_[own], b.rules, b.triangles,
                   b.pieces, b.heads, b.points, b.states);
        return b.states.read(0, lists_[own].count);
    }

private:
    /// Places of a class's list in the buffers.
    struct Room
    {
        std::size_t pieces = 0, guide = 0;
    };

    bool fits(const ClassPieces& open, std::size_t own) const
    {
        return open.pieces.size() <= rooms_[own].pieces && open.choice.guide.size() <= rooms_[own].guide;
    }

    void write_list(const ClassPieces& open, std::size_t own)
    {
        if (open.pieces.empty()) return;
        OpenPieces& list = lists_[own];
        list.total = open.choice.total();
        list.count = word(open.pieces.size());
        list.guide_bits = open.choice.guide_bits;
        list.spread = open.spread;
        buffers_->pieces.write(open.pieces, list.first);
        buffers_->ends.write(open.choice.ends, list.first);
        buffers_->guide.write(open.choice.guide, list.first_guide);
    }

    std::shared_ptr<const FixedSurface> surface_;
    StreamKey stream_;
    std::vector<OpenPieces> lists_; ///< of each class
    std::vector<Room> rooms_;
    Kernel find_, settle_, cover_;
};

}

std::unique_ptr<ClassSurfaceEngine> class_surface_engine(const ClassSurfaceRequest& request, const Device& device,
                                                         std::size_t work_group_size)
{
    return std::make_unique<KernelClassSurface>(request, device, work_group_size);
}

DeviceMemory class_surface_memory(const FixedSurface& surface, std::size_t points, std::size_t classes)
{
    ClassSurfaceBuffers buffers;
    const std::size_t pieces = classes * surface.triangles.size() + pieces_a_point * points;
    DeviceMemory memory =
        memory_of(buffers_for(buffers, classes, points + most_surface_slots, surface_bucket_count(points))) +
        memory_of(buffers_of_lists(buffers, pieces, pieces));
    return memory.add(surface.triangles.size() * sizeof(SurfaceTriangle));
}

}
