// Points that follow a density: even points through its inverse cumulative distribution.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 7.2 and 7.3: y chooses the row of pixels and the place
// in it, x the pixel of that row and the place in it. Even points stay even in a constant density and crowd where a
// density changes from row to row, as the rows are warped each on their own.
#pragma once

#include "base/densities/density.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/device_method.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Even points of the unit square, x and y in turn, each in parts of 2^32.
using SquarePoints = std::vector<std::uint32_t>;

/// Places in a density's rectangle, x and y in turn, each in pixels times 2^32, from the lower left.
using PixelPlaces = std::vector<std::uint64_t>;

/// Sums of a density's weights: exact, so that it matters nowhere in which order they are made.
struct WarpTable
{
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint64_t> row_sums;  ///< height + 1: all rows below
    std::vector<std::uint64_t> sums;      ///< height times width + 1: in its row, all pixels to the left
    std::vector<std::uint32_t> row_guide; ///< height + 1: the row of the least y of each height-th of the square
    std::vector<std::uint32_t> guide;     ///< height times width + 1: the same in each row

    explicit WarpTable(const Density& density);

    std::uint64_t total() const { return row_sums.back(); }
};

namespace reference {
PixelPlaces warp_points(const WarpTable& table, std::span<const std::uint32_t> points);
}

/// Warps points by kernels/warp.cl, bit for bit as the reference does. The table is copied to the device once.
class PointWarper
{
public:
    /// `work_group_size` 0: the default.
    PointWarper(Device device, const WarpTable& table, std::size_t work_group_size = 0);

    /// The memory that warping so many points by a density of this size takes.
    static DeviceMemory memory(std::size_t width, std::size_t height, std::size_t points);

    PixelPlaces warp(std::span<const std::uint32_t> points);

    /// Enqueues the same for points that are on the device, and leaves the places there; `places` has room for them.
    void warp(const Buffer<std::uint32_t>& points, std::size_t count, Buffer<std::uint64_t>& places);

private:
    struct Buffers
    {
        Buffer<std::uint64_t> row_sums, sums, places;
        Buffer<std::uint32_t> row_guide, guide, points;

        NeededBuffers needed(std::size_t width, std::size_t height, std::size_t count);
    };

    Device device_;
    std::size_t work_group_size_;
    std::uint32_t width_, height_;
    Buffers buffers_;
    Kernel warp_;
};

/// A place as a coordinate in units of `longest` pixels: below 1 where the place is below `longest`.
double place_coordinate(std::uint64_t place, std::uint32_t longest);

}
