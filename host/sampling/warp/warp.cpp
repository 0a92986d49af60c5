#include "host/sampling/warp/warp.hpp"

#include "kernels/common/fields/warp.h"

namespace poissonlab {
namespace {

/// total * u / 2^32, rounded down, for totals below 2^63.
std::uint64_t part_of_total(std::uint64_t total, std::uint64_t u)
{
    return (total >> 32) * u + ((total & 0xffffffff) * u >> 32);
}

/// Appends the guide of n cells with these n + 1 sums: of each n-th of all u its first one's cell, and the last cell.
void append_guide(std::span<const std::uint64_t> sums, std::vector<std::uint32_t>& guide)
{
    const std::uint64_t n = sums.size() - 1;
    std::uint32_t cell = 0;
    for (std::uint64_t part = 0; part <= n; ++part) {
        const std::uint64_t u = part == n ? 0xffffffff : ((part << 32) + n - 1) / n;
        const std::uint64_t t = part_of_total(sums[n], u);
        while (cell + 1 < n && sums[cell + 1] <= t) ++cell;
        guide.push_back(cell);
    }
}

constexpr std::size_t warp_group_size = 64;

}

WarpTable::WarpTable(const Density& density)
    : width(static_cast<std::uint32_t>(density.width)), height(static_cast<std::uint32_t>(density.height))
{
    const std::size_t stride = std::size_t{width} + 1;
    row_sums.push_back(0);
    sums.reserve(height * stride);
    guide.reserve(height * stride);
    for (std::size_t row = 0; row < height; ++row) {
        std::uint64_t sum = 0;
        sums.push_back(0);
        for (std::size_t column = 0; column < width; ++column)
            sums.push_back(sum += density.weights[row * width + column]);
        row_sums.push_back(row_sums.back() + sum);
        append_guide(std::span(sums).subspan(row * stride), guide);
    }
    append_guide(row_sums, row_guide);
}

NeededBuffers PointWarper::Buffers::needed(std::size_t width, std::size_t height, std::size_t count)
{
    return {{row_sums, height + 1},        {sums, height * (width + 1)}, {row_guide, height + 1},
            {guide, height * (width + 1)}, {points, 2 * count},          {places, 2 * count}};
}

PointWarper::PointWarper(Device device, const WarpTable& table, std::size_t work_group_size)
    : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : warp_group_size),
      width_(table.width), height_(table.height), warp_(device_.kernel(kernel_program("warp.cl", {}), "warp_points"))
{
    reserve(device_, buffers_.needed(width_, height_, 0));
    buffers_.row_sums.write(table.row_sums);
    buffers_.sums.write(table.sums);
    buffers_.row_guide.write(table.row_guide);
    buffers_.guide.write(table.guide);
}

DeviceMemory PointWarper::memory(std::size_t width, std::size_t height, std::size_t points)
{
    return memory_of(Buffers{}.needed(width, height, points));
}

void PointWarper::warp(const Buffer<std::uint32_t>& points, std::size_t count, Buffer<std::uint64_t>& places)
{
    using namespace contract::warp;
    const Warping warping{static_cast<std::uint32_t>(count), width_, height_};
    warp_.run((count + POINTS_AN_ITEM - 1) / POINTS_AN_ITEM, work_group_size_, warping, buffers_.row_sums,
              buffers_.row_guide, buffers_.sums, buffers_.guide, points, places);
}

PixelPlaces PointWarper::warp(std::span<const std::uint32_t> points)
{
    reserve(device_, buffers_.points, points.size());
    reserve(device_, buffers_.places, points.size());
    buffers_.points.write(points);
    warp(buffers_.points, points.size() / 2, buffers_.places);
    PixelPlaces places(points.size());
    buffers_.places.read(std::span(places));
    return places;
}

double place_coordinate(std::uint64_t place, std::uint32_t longest)
{
    // Doubles hold 53 bits; what is cut off cannot round a coordinate up to the next pixel.
    if (place >> 53 != 0) return static_cast<double>(place & ~std::uint64_t{0xfff}) / 4294967296.0 / longest;
    return static_cast<double>(place) / 4294967296.0 / longest;
}

}
