#include "host/sampling/darts/dart_settler.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/torus.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace poissonlab {
namespace {

using namespace contract::dart_throwing;

/// Layers of cells that a slab owns at least: darts near its ends are looked at twice, and wait for each other.
constexpr std::uint32_t least_slab_layers = 16;

/// Cells of a slab, nearly, where the torus has many: darts come in the order of their times, from anywhere in the
/// slab, and what is known of its cells should stay in a processor's cache.
constexpr std::size_t usual_slab_cells = std::size_t{1} << 18;

/// Bricks of a slab at least.
constexpr std::size_t least_slab_bricks = 64;

/// Darts in a bucket of time, nearly: they are sorted by insertion.
constexpr std::size_t darts_a_bucket = 4;

/// Slabs of mark_points for each thread, so that none waits for long, and the layers of each at least.
constexpr std::uint32_t marking_slabs_a_thread = 4;
constexpr std::uint32_t least_marking_layers = 6;

/// Resolution rounds that are enqueued before the host looks whether all darts are decided, and each time after that.
constexpr std::uint32_t first_rounds = 6;
constexpr std::uint32_t further_rounds = 3;

/// Darts that one work-item of insert_points owns.
constexpr std::uint32_t insertion_run = 16;

std::uint32_t words32(std::size_t value) { return static_cast<std::uint32_t>(value); }

std::uint32_t slab_count(const DartTorus& torus, unsigned compute_units)
{
    const std::size_t cells = lattice_cells(torus.grid_size, torus.dimension);
    return std::clamp(torus.grid_size / least_slab_layers, 1u,
                      std::max({1u, compute_units, words32(cells / usual_slab_cells)}));
}

/// Words of a row of cells in `accepted`: a bit for each cell, and REACH more on either side; a word beyond that is
/// read, but does not matter.
std::uint32_t row_words(const DartTorus& torus)
{
    return (torus.grid_size + 2 * words32(static_cast<std::size_t>(torus.hierarchy.reach)) + 31) / 32 + 1;
}

/// The logarithm of the number of buckets of a slab.
std::uint32_t bucket_bits(std::size_t darts, std::uint32_t slabs)
{
    return std::clamp<std::uint32_t>(words32(static_cast<std::size_t>(std::bit_width(darts / slabs / darts_a_bucket))),
                                     1, 24);
}

NeededBuffers in_order_buffers(DartBuffers& b, const DartTorus& torus, unsigned compute_units, std::size_t darts)
{
    const std::uint32_t slabs = slab_count(torus, compute_units);
    const std::size_t listed = slabs == 1 ? darts : 2 * darts; // slabs look at darts of each other
    const std::size_t rows = lattice_cells(torus.grid_size, torus.dimension - 1);
    const std::size_t layer = rows; // a layer has as many cells as there are rows
    const std::size_t ghosts = slabs == 1 ? 0 : 2 * slabs * static_cast<std::size_t>(torus.hierarchy.reach);
    return {{b.states, darts},
            {b.next, listed},
            {b.keys, listed},
            {b.buckets, std::size_t{slabs} << bucket_bits(darts, slabs)},
            {b.accepted, rows * row_words(torus)},
            {b.slots, (torus.grid_size + ghosts) * layer}};
}

NeededBuffers in_rounds_buffers(DartBuffers& b, const DartTorus& torus, std::size_t darts)
{
    return {{b.slots, torus.cells()},
            {b.next, darts},
            {b.states, darts},
            {b.next_states, darts},
            {b.rivals, darts * RIVAL_WORDS}};
}

class InOrder : public DartSettler
{
public:
    InOrder(Device& device, const DartTorus& torus)
        : device_(device), torus_(torus), threads_(device.info().compute_units)
    {
        const KernelProgram program = dart_program("darts_in_order.cl", torus);
        settle_ = device.kernel(program, "settle_darts");
        mark_ = device.kernel(program, "mark_points");
    }

    void settle(DartBuffers& b, std::size_t dart_count) override
    {
        reserve(device_, in_order_buffers(b, torus_, threads_, dart_count));
        const std::uint32_t slabs = slab_count(torus_, threads_);
        run(b, slabs, dart_count, false);
        if (slabs > 1) run(b, 1, dart_count, true);
    }

    void prepare_batch(DartBuffers& b) override
    {
        const std::uint32_t slabs =
            std::clamp(torus_.grid_size / least_marking_layers, 1u, marking_slabs_a_thread * std::max(1u, threads_));
        mark_.run(slabs, 1, slabs, torus_.part, torus_.grid_size, row_words(torus_), torus_.hierarchy.step,
                  torus_.squared_min_distance, b.accepted, b.positions, b.masks);
    }

private:
    void run(DartBuffers& b, std::uint32_t slabs, std::size_t dart_count, bool is_rest)
    {
        const Slabs arguments{.squared_min_distance = torus_.squared_min_distance,
                              .slabs = slabs,
                              .grid_size = torus_.grid_size,
                              .row_words = row_words(torus_),
                              .darts = words32(dart_count),
                              .bucket_bits = bucket_bits(dart_count, slab_count(torus_, threads_)),
                              .is_rest = is_rest};
        settle_.run(slabs, 1, arguments, b.darts, b.states, b.buckets, b.keys, b.next, b.slots, b.accepted, b.positions,
                    b.points, b.counters);
    }

    Device& device_;
    DartTorus torus_;
    unsigned threads_;
    Kernel settle_, mark_;
};

/// Slabs of bricks: darts at their ends wait for each other.
std::uint32_t brick_slabs(const DartTorus& torus, unsigned compute_units)
{
    return std::clamp(words32(torus.bricks->count() / least_slab_bricks), 1u,
                      std::max({1u, compute_units, words32(torus.cells() / usual_slab_cells)}));
}

NeededBuffers in_bricks_buffers(DartBuffers& b, const DartTorus& torus, unsigned compute_units, std::size_t darts)
{
    const std::uint32_t slabs = brick_slabs(torus, compute_units);
    return {{b.slots, torus.cells()},
            {b.states, darts},
            {b.next, darts},
            {b.keys, darts},
            {b.buckets, std::size_t{slabs} << bucket_bits(darts, slabs)},
            {b.accepted_bits, torus.bricks->count()},
            {b.waiting_bits, torus.bricks->count()}};
}

class InBricks : public DartSettler
{
public:
    InBricks(Device& device, const DartTorus& torus)
        : device_(device), torus_(torus), slabs_(brick_slabs(torus, device.info().compute_units)),
          settle_(device.kernel(dart_program("darts_in_bricks.cl", torus), "settle_darts"))
    {}

    void settle(DartBuffers& b, std::size_t dart_count) override
    {
        reserve(device_, in_bricks_buffers(b, torus_, device_.info().compute_units, dart_count));
        run(b, slabs_, dart_count, false);
        if (slabs_ > 1) run(b, 1, dart_count, true);
    }

private:
    void run(DartBuffers& b, std::uint32_t slabs, std::size_t dart_count, bool is_rest)
    {
        const Slabs arguments{.squared_min_distance = torus_.squared_min_distance,
                              .slabs = slabs,
                              .grid_size = words32(torus_.bricks->count()),
                              .row_words = 0,
                              .darts = words32(dart_count),
                              .bucket_bits = bucket_bits(dart_count, slabs_),
                              .is_rest = is_rest};
        settle_.run(slabs, 1, arguments, b.darts, b.states, b.buckets, b.keys, b.next, b.slots, b.accepted_bits,
                    b.waiting_bits, b.positions, b.points, b.counters, torus_.part, torus_.hierarchy.step, b.masks,
                    b.brick_corners, b.bricks_around);
    }

    Device& device_;
    DartTorus torus_;
    std::uint32_t slabs_;
    Kernel settle_;
};

class InRounds : public DartSettler
{
public:
    InRounds(Device& device, const DartTorus& torus, std::size_t group_size)
        : device_(device), torus_(torus), group_size_(group_size)
    {
        const KernelProgram program = dart_program("darts_in_rounds.cl", torus);
        link_ = device.kernel(program, "link_darts");
        resolve_ = device.kernel(program, "resolve_conflicts");
        insert_ = device.kernel(program, "insert_points");
    }

    void settle(DartBuffers& b, std::size_t dart_count) override
    {
        reserve(device_, in_rounds_buffers(b, torus_, dart_count));
        if (first_dart_ + dart_count >= UINT32_MAX) throw DeviceError("dart throwing: more than 2^32 darts");
        resolve(b, dart_count);
        first_dart_ += dart_count;
        if (dart_count == 0) return;
        torus_.run_with_bricks(b, [&](const auto&... bricks) {
            insert_.run((dart_count + insertion_run - 1) / insertion_run, group_size_, b.darts, words32(dart_count),
                        insertion_run, b.states, torus_.part, torus_.grid_size, torus_.hierarchy.step,
                        torus_.squared_min_distance, b.masks, b.positions, b.points, b.counters, bricks...);
        });
    }

private:
    /// Decides all darts of the batch.
    void resolve(DartBuffers& b, std::size_t dart_count)
    {
        // At least one work-item, which clears the counters.
        link_.run(std::max<std::size_t>(dart_count, 1), group_size_, b.darts, words32(dart_count), words32(first_dart_),
                  b.slots, b.next, b.states, b.counters);
        std::uint32_t rounds = 0;
        for (std::uint32_t waiting = dart_count > 0 ? 0 : 1; waiting == rounds;) {
            const std::uint32_t end = rounds + (rounds == 0 ? first_rounds : further_rounds);
            for (; rounds < end; ++rounds) {
                torus_.run_with_bricks(b, [&](const auto&... bricks) {
                    resolve_.run(dart_count, group_size_, b.darts, words32(dart_count), words32(first_dart_), rounds,
                                 b.slots, b.next, torus_.grid_size, torus_.squared_min_distance, b.rivals, b.states,
                                 b.next_states, b.counters, torus_.part, bricks...);
                });
                std::swap(b.states, b.next_states);
            }
            b.counters.read({&waiting, 1}, WAITING_ROUND);
        }
    }

    Device& device_;
    DartTorus torus_;
    std::size_t group_size_;
    Kernel link_, resolve_, insert_;
    std::size_t first_dart_ = 0; ///< number of the batch's first dart
};

}

DartSettling settling_for(const DeviceInfo& device)
{
    return device.type == "CPU" ? DartSettling::in_order : DartSettling::in_rounds;
}

DartTorus::DartTorus(double min_distance, int dimension, const std::optional<DartBlock>& block,
                     std::shared_ptr<const DartBricks> bricks)
    : dimension(dimension), hierarchy(cell_hierarchy(min_distance, dimension)), part{{}, hierarchy.size},
      grid_size(bricks  ? 0
                : block ? block->size
                        : hierarchy.size),
      squared_min_distance(squared_threshold(min_distance)), has_large_disks(min_distance > 0.25),
      bricks(std::move(bricks))
{
    if (block) std::ranges::copy(block->first, std::begin(part.first));
}

std::size_t DartTorus::cells() const { return bricks ? bricks->cells() : lattice_cells(grid_size, dimension); }

KernelProgram dart_program(const std::string& file, const DartTorus& torus)
{
    return kernel_program(file, {{"DIMENSION", torus.dimension},
                                 {"REACH", torus.hierarchy.reach},
                                 {"LARGE_DISKS", torus.has_large_disks},
                                 {"BRICKS", torus.bricks != nullptr}});
}

std::unique_ptr<DartSettler> make_dart_settler(Device& device, DartSettling settling, const DartTorus& torus,
                                               std::size_t group_size)
{
    if (settling == DartSettling::in_rounds) return std::make_unique<InRounds>(device, torus, group_size);
    if (torus.bricks) return std::make_unique<InBricks>(device, torus);
    return std::make_unique<InOrder>(device, torus);
}

NeededBuffers settling_buffers(DartBuffers& buffers, DartSettling settling, const DartTorus& torus,
                               unsigned compute_units, std::size_t most_darts)
{
    if (settling == DartSettling::in_rounds) return in_rounds_buffers(buffers, torus, most_darts);
    return torus.bricks ? in_bricks_buffers(buffers, torus, compute_units, most_darts)
                        : in_order_buffers(buffers, torus, compute_units, most_darts);
}

}
