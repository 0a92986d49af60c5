// The darts of a batch are settled among themselves: some of them become points.
#pragma once

#include "host/device/device.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"
#include "host/sampling/cells/region_buffers.hpp"
#include "host/sampling/darts/dart_request.hpp"
#include "kernels/common/darts/dart_throwing.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace poissonlab {

// These buffers hold the cells, points and darts of dart throwing on the device.

struct DartBuffers
{
    using Words = Buffer<std::uint32_t>;

    Words thresholds;              ///< of the batch at hand
    Words masks, positions, slots; ///< a level 0 cell each
    Words parents, open;           ///< open cells before and after a batch
    Words darts, states, next;     ///< a dart of the batch each
    Words points, counters;
    LandBuffers land;

    // Only grids of bricks need these.
    Words brick_corners, bricks_around;
    Buffer<std::uint64_t> accepted_bits, waiting_bits; ///< a brick each, where darts are settled in order

    // Only darts that are settled in order need these.
    Words accepted;             ///< a bit of a level 0 cell each
    Words buckets;              ///< an interval of time of a slab each
    Buffer<std::uint64_t> keys; ///< a dart of a slab each

    // Only darts that are settled in rounds need these.
    Words next_states, rivals; ///< a dart of the batch each
};

/// The ways to do it, whose results are the same.
enum class DartSettling
{
    in_order,  ///< by kernels/darts_in_order.cl or, in bricks, kernels/darts_in_bricks.cl: a few work-items, one dart
               ///< after the other
    in_rounds, ///< by kernels/darts_in_rounds.cl: a work-item a dart, again and again
};

/// The faster way for a device.
DartSettling settling_for(const DeviceInfo& device);

/// The torus in which darts have a minimum distance, and the part of it that they fall into.
struct DartTorus
{
    DartTorus(double min_distance, int dimension, const std::optional<DartBlock>& block = {},
              std::shared_ptr<const DartBricks> bricks = {});

    /// The number of cells in the grid.
    std::size_t cells() const;

    /// Calls run() with the arguments that kernels take for bricks, if the grid consists of them.
    template <typename Run>
    void run_with_bricks(const DartBuffers& buffers, const Run& run) const
    {
        if (bricks)
            run(buffers.brick_corners, buffers.bricks_around);
        else
            run();
    }

    int dimension;
    CellHierarchy hierarchy;
    contract::dart_throwing::GridPart part;   ///< that the grid holds
    std::uint32_t grid_size;                  ///< cells of level 0 along each axis of the grid; 0 with bricks
    std::uint64_t squared_min_distance;       ///< units of 2^-64
    bool has_large_disks;                     ///< so large that they wrap around
    std::shared_ptr<const DartBricks> bricks; ///< that the grid consists of; empty: it is a cube
};

/// A program of dart throwing: the file with the constants of the torus.
KernelProgram dart_program(const std::string& file, const DartTorus& torus);

class DartSettler
{
public:
    virtual ~DartSettler() = default;

    /// Appends the accepted ones of `dart_count` darts to the points, puts them into the grid, and clears the counters
    /// of the batch.
    virtual void settle(DartBuffers& buffers, std::size_t dart_count) = 0;

    /// Makes ready for another batch.
    virtual void prepare_batch(DartBuffers&) {}
};

/// A settler for batches of one set. `group_size` work-items are a group where the way has no reason for another
/// number.
std::unique_ptr<DartSettler> make_dart_settler(Device& device, DartSettling settling, const DartTorus& torus,
                                               std::size_t group_size);

/// The buffers that settling takes beside those of throwing, for batches of up to `most_darts`.
NeededBuffers settling_buffers(DartBuffers& buffers, DartSettling settling, const DartTorus& torus,
                               unsigned compute_units, std::size_t most_darts);

}
