#include "tiles/poisson/tile_regions.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

/// The smallest integer that is at least factor * sqrt(2) * width.
std::int32_t root_two_times(std::int64_t factor, std::int64_t width)
{
    const std::int64_t squared = 2 * factor * factor * width * width;
    auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(squared)));
    while (root * root >= squared && root > 0) --root;
    while (root * root < squared) ++root;
    return static_cast<std::int32_t>(root);
}

bool is_in_pair(const TileRegions& regions, std::int32_t a, std::int32_t b)
{
    return a < regions.pair_one && b < regions.pair_one && a + b < regions.pair_sum;
}

bool is_in_corner(const TileRegions& regions, std::array<std::int32_t, 3> folded)
{
    if (regions.dimension == 2) return is_in_pair(regions, folded[0], folded[1]);
    std::ranges::sort(folded);
    return folded[2] < regions.corner_one && folded[2] + folded[1] < regions.corner_two &&
           folded[2] + folded[1] + folded[0] < regions.corner_three;
}

}

TileRegions modified_regions(int dimension, std::int32_t width)
{
    TileRegions regions{dimension, width};
    const std::int32_t reach = width + root_two_times(1, width);
    regions.pair_one = reach;
    regions.pair_sum = reach + width;
    regions.corner_one = width + root_two_times(2, width);
    regions.corner_two = 2 * width + root_two_times(3, width);
    regions.corner_three = 3 * width + root_two_times(3, width);
    return regions;
}

TileRegions unmodified_regions(int dimension, std::int32_t width)
{
    if (dimension == 2) return frame_regions(width);
    return {3, width, width, 2 * width, width, 2 * width, 3 * width};
}

TileRegions frame_regions(std::int32_t width) { return {2, width, width, 2 * width, 0, 0, 0}; }

std::uint8_t TileRegions::axes_at(const std::array<std::int32_t, 3>& folded) const
{
    const std::uint8_t all = all_axes(dimension);
    if (is_in_corner(*this, folded)) return 0;
    if (dimension == 3) {
        for (int k = 0; k < 3; ++k) {
            if (is_in_pair(*this, folded[(k + 1) % 3], folded[(k + 2) % 3])) return static_cast<std::uint8_t>(1 << k);
        }
    }
    for (int k = 0; k < dimension; ++k) {
        if (folded[k] < width) return static_cast<std::uint8_t>(all & ~(1 << k));
    }
    return all;
}

TileCell TileRegions::cell_of(std::span<const std::uint16_t> position) const
{
    std::array<std::int32_t, 3> folded{};
    std::uint8_t upper = 0;
    for (int k = 0; k < dimension; ++k) {
        const std::int32_t coordinate = position[static_cast<std::size_t>(k)];
        folded[k] = std::min(coordinate, tile_units - coordinate);
        if (coordinate > tile_units - coordinate) upper |= static_cast<std::uint8_t>(1 << k);
    }
    const std::uint8_t axes = axes_at(folded);
    return {axes, static_cast<std::uint8_t>(upper & ~axes)};
}

double TileRegions::volume(std::uint8_t axes) const
{
    const auto unit = [](double value) { return value / tile_units; };
    const double r = unit(width);
    const double a = unit(pair_one);
    const double cut = unit(2 * pair_one - pair_sum); // legs of the triangles that the octagon's corners lose
    const double octagon = 4 * a * a - 2 * cut * cut;
    if (dimension == 2) {
        if (axes == 0) return octagon;
        if (axes != 3) return 2 * r * (1 - 2 * a);
        return 1 - octagon - 4 * r * (1 - 2 * a);
    }
    const double b = unit(corner_one);
    const double edge = octagon * (1 - 2 * b);
    const double face_cut = unit(corner_two - 2 * pair_one);
    const double face = 2 * r * ((1 - 2 * a) * (1 - 2 * a) - 2 * face_cut * face_cut);
    // Great rhombicuboctahedron with edges of two radii: (22 + 14 sqrt 2) (2 r)^3.
    const double corner = (22 + 14 * std::sqrt(2.0)) * 8 * r * r * r;
    switch (std::popcount(axes)) {
    case 0:
        return corner;
    case 1:
        return edge;
    case 2:
        return face;
    default:
        return 1 - corner - 3 * edge - 3 * face;
    }
}

}
