// Runs kernels/surfaces/surface_darts.cl.
#include "host/device/needed_buffers.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace poissonlab {

namespace {

using contract::surface::ACCEPTED;
using contract::surface::SurfaceBatch;
using contract::surface::SurfaceRule;

struct SurfaceDartBuffers
{
    using Words = Buffer<std::uint32_t>;

    Buffer<SurfaceTriangle> triangles;
    Buffer<SurfacePiece> pieces;
    Buffer<std::uint64_t> ends;
    Words guide, piece_states;
    Buffer<SurfacePoint> points, darts;
    Words heads, dart_heads, order, states, undecided;
};

/// Darts are sorted into groups of 2^that many, about.
constexpr int darts_side_by_side = 3;

/// Rounds that are enqueued before the host looks whether darts are left.
constexpr int settling_rounds = 3;

/// Pieces for each point that there are at most, about.
constexpr std::size_t pieces_a_point = 6;

NeededBuffers buffers_of_points(SurfaceDartBuffers& b, std::size_t points)
{
    return {{b.points, points}, {b.heads, surface_bucket_count(points)}};
}

NeededBuffers buffers_of_darts(SurfaceDartBuffers& b, std::size_t darts)
{
    return {{b.darts, darts}, {b.order, darts}, {b.states, darts}, {b.dart_heads, surface_bucket_count(darts)}};
}

NeededBuffers buffers_of_pieces(SurfaceDartBuffers& b, std::size_t pieces, std::size_t guide)
{
    return {{b.pieces, pieces}, {b.ends, pieces}, {b.guide, guide}, {b.piece_states, pieces}};
}

class KernelSurfaceDarts final : public SurfaceDartEngine, DeviceMethod<SurfaceDartBuffers>
{
public:
    KernelSurfaceDarts(const SurfaceDartRequest& request, const Device& device, std::size_t work_group_size)
        : DeviceMethod(device, work_group_size, std::make_shared<SurfaceDartBuffers>()), stream_(request.stream)
    {
        const KernelProgram program = kernel_program("surfaces/surface_darts.cl", {});
        find_ = device_.kernel(program, "find_darts");
        settle_ = device_.kernel(program, "settle_darts");
        clear_ = device_.kernel(program, "clear_darts");
        add_ = device_.kernel(program, "add_points");
        cover_ = device_.kernel(program, "cover_pieces");
        reserve(device_, buffers_->triangles, request.surface->triangles.size());
        buffers_->triangles.write(request.surface->triangles);
        reserve(device_, buffers_->undecided, 1);
    }

    void restart(const SurfaceRule& rule, const std::vector<SurfacePoint>& points, std::size_t capacity) override
    {
        rule_ = rule;
        const std::size_t buckets = surface_bucket_count(capacity);
        rule_.bucket_mask = static_cast<std::uint32_t>(buckets - 1);
        reserve(device_, buffers_of_points(*buffers_, capacity));
        buffers_->heads.write(std::vector<std::uint32_t>(buckets));
        count_ = 0;
        std::vector<SurfacePoint> by_buckets;
        by_buckets.reserve(points.size());
        for (const std::uint32_t id : surface_bucket_order(points, rule_.cell, rule_.bucket_mask).ids)
            by_buckets.push_back(points[id]);
        add(by_buckets);
    }

    void set_pieces(const std::vector<SurfacePiece>& pieces) override
    {
        pieces_ = pieces.size();
        SurfaceDartBuffers& b = *buffers_;
        if (b.pieces.size() < pieces_ || b.guide.size() < surface_guide_size(pieces_)) {
            const std::size_t room = b.pieces.size() < pieces_ ? pieces_ * 3 / 2 : b.pieces.size();
            reserve(device_, buffers_of_pieces(b, room, surface_guide_size(room)));
            for (BufferImpl* memory : {&b.pieces.impl(), &b.ends.impl(), &b.guide.impl()}) ask_for_large_pages(*memory);
        }
        buffers_->pieces.write(pieces);
    }

    void set_choice(const SurfacePieceChoice& choice) override
    {
        total_ = choice.total();
        guide_bits_ = choice.guide_bits;
        buffers_->ends.write(choice.ends);
        buffers_->guide.write(choice.guide);
    }

    std::vector<SurfacePoint> throw_darts(std::uint64_t first, std::uint32_t darts, std::size_t most) override
    {
        SurfaceDartBuffers& b = *buffers_;
        if (b.states.size() < darts) {
            reserve(device_, buffers_of_darts(b, std::bit_ceil(darts)));
            b.dart_heads.write(std::vector<std::uint32_t>(b.dart_heads.size()));
        }
        const SurfaceBatch batch{.total = total_,
                                 .first = first,
                                 .darts = darts,
                                 .guide_bits = guide_bits_,
                                 .key_x = stream_[0],
                                 .key_y = stream_[1],
                                 .bucket_mask = static_cast<std::uint32_t>(b.dart_heads.size() - 1),
                                 .pieces = static_cast<std::uint32_t>(pieces_)};
        b.order.write(order_of(first, darts));
        find_.run(darts, work_group_size_, batch, rule_, b.order, b.triangles, b.pieces, b.ends, b.guide, b.heads,
                  b.points, b.darts, b.states, b.dart_heads);
        settle(batch);
        clear_.run(darts, work_group_size_, batch, rule_, b.darts, b.states, b.dart_heads);
        std::vector<SurfacePoint> accepted = accepted_of(darts, most);
        add(accepted);
        std::ranges::sort(accepted, {}, &SurfacePoint::number);
        for (SurfacePoint& point : accepted) point.number = 0;
        return accepted;
    }

    std::vector<std::uint32_t> cover() override
    {
        SurfaceDartBuffers& b = *buffers_;
        const auto count = static_cast<std::uint32_t>(pieces_);
        cover_.run(pieces_, work_group_size_, count, rule_, b.triangles, b.pieces, b.heads, b.points, b.piece_states);
        return b.piece_states.read(0, pieces_);
    }

private:
    void settle(const SurfaceBatch& batch)
    {
        SurfaceDartBuffers& b = *buffers_;
        for (std::uint32_t left = 1; left > 0;) {
            for (int round = 0; round < settling_rounds; ++round) {
                b.undecided.write(std::vector<std::uint32_t>(1));
                settle_.run(batch.darts, work_group_size_, batch, rule_, b.triangles, b.darts, b.dart_heads, b.states,
                            b.undecided);
            }
            left = b.undecided.read(0, 1).front();
        }
    }

    /// The numbers of a batch's darts, by the random words that choose their pieces.
    std::vector<std::uint32_t> order_of(std::uint64_t first, std::uint32_t darts) const
    {
        const int shift = 32 - std::max(1, static_cast<int>(std::bit_width(darts)) - darts_side_by_side);
        std::vector<std::uint32_t> starts((std::size_t{1} << (32 - shift)) + 1), groups(darts), order(darts);
        for (std::uint32_t i = 0; i < darts; ++i) {
            const std::uint64_t number = first + i;
            groups[i] = philox({static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32), 0, 0},
                               stream_)[0] >>
                        shift;
            ++starts[groups[i] + 1];
        }
        std::partial_sum(starts.begin(), starts.end(), starts.begin());
        for (std::uint32_t i = 0; i < darts; ++i) order[starts[groups[i]]++] = i;
        return order;
    }

    /// The first `most` of the darts that are accepted, in the order in which they lie on the device.
    std::vector<SurfacePoint> accepted_of(std::uint32_t darts, std::size_t most)
    {
        states_.resize(darts);
        darts_.resize(darts);
        buffers_->states.read(states_);
        buffers_->darts.read(darts_);
        std::vector<SurfacePoint> accepted;
        for (std::uint32_t i = 0; i < darts; ++i)
            if (states_[i] == ACCEPTED) {
                accepted.push_back(darts_[i]);
                accepted.back().next = 0;
            }
        if (accepted.size() <= most) return accepted;
        std::vector<std::uint32_t> numbers;
        for (const SurfacePoint& point : accepted) numbers.push_back(point.number);
        const auto end = numbers.begin() + static_cast<std::ptrdiff_t>(most);
        std::ranges::nth_element(numbers, end);
        std::erase_if(accepted, [&](const SurfacePoint& point) { return point.number >= *end; });
        return accepted;
    }

    void add(const std::vector<SurfacePoint>& points)
    {
        buffers_->points.write(points, count_);
        add_.run(points.size(), work_group_size_, rule_, static_cast<std::uint32_t>(count_),
                 static_cast<std::uint32_t>(points.size()), buffers_->points, buffers_->heads);
        count_ += points.size();
    }

    StreamKey stream_;
    SurfaceRule rule_{};
    std::size_t count_ = 0;             ///< points
    std::vector<std::uint32_t> states_; ///< of a batch, as the device has them
    std::vector<SurfacePoint> darts_;
    std::size_t pieces_ = 0;
    std::uint64_t total_ = 0;
    std::uint32_t guide_bits_ = 0;
    Kernel find_, settle_, clear_, add_, cover_;
};

}

std::unique_ptr<SurfaceDartEngine> surface_dart_engine(const SurfaceDartRequest& request, const Device& device,
                                                       std::size_t work_group_size)
{
    return std::make_unique<KernelSurfaceDarts>(request, device, work_group_size);
}

DeviceMemory surface_dart_memory(const FixedSurface& surface, std::size_t points)
{
    SurfaceDartBuffers buffers;
    const std::size_t pieces = surface.triangles.size() + pieces_a_point * points;
    DeviceMemory memory = memory_of(buffers_of_points(buffers, points)) + memory_of(buffers_of_darts(buffers, points)) +
                          memory_of(buffers_of_pieces(buffers, pieces, pieces));
    return memory.add(surface.triangles.size() * sizeof(SurfaceTriangle));
}

}
