// Points of polyominoes on a device, by kernels/polyominoes.cl: those of polyomino_points(), bit for bit.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "tiles/polyominoes/polyomino_points.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// Makes sets of one size. The table's row for it is copied to the device once.
class PolyominoGenerator
{
public:
    /// `work_group_size` 0: the default.
    PolyominoGenerator(Device device, Polyomino shape, std::size_t work_group_size = 0);

    /// The memory that a generator takes for sets of so many points on a torus of so many cells along each axis. The
    /// number of classes of neighbourhoods is known: 58 for P, 188 for G.
    static DeviceMemory memory(Polyomino shape, std::uint32_t side, std::size_t points);

    /// Exactly `points` points, fewer than 2^32.
    PointSet points(const PolyominoTorus& torus, std::size_t points);

private:
    struct Sizes
    {
        std::size_t roots, tiles, children, classes, row, points;
    };

    struct Buffers
    {
        Buffer<std::uint32_t> order, next;
        Buffer<std::array<std::int32_t, 4>> tiles, children;
        Buffer<Correction> corrections;
        Buffer<std::array<std::uint64_t, 2>> points;

        NeededBuffers needed(const Sizes& sizes);
    };

    Device device_;
    std::size_t work_group_size_;
    Buffers buffers_;
    Kernel place_points_;
};

}
