// Random regions for tests and benchmarks.
#pragma once

#include "base/regions/plane_region.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace poissonlab::test {

/// A ring around (x, y) whose corners have directions that grow and distances from least to most: whole numbers. Where
/// `reach` is given, the corners on both axes are so far.
inline RegionRing star(std::mt19937& random, int corners, double x, double y, double least, double most,
                       double reach = 0)
{
    RegionRing ring;
    corners = (corners + 3) / 4 * 4;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        const double radius = least + (most - least) * static_cast<double>(random() % 1024) / 1024;
        ring.push_back({std::round(x + radius * std::cos(angle)), std::round(y + radius * std::sin(angle))});
    }
    if (reach == 0) return ring;
    const auto quarter = static_cast<std::size_t>(corners / 4);
    ring[0] = {std::ceil(x + reach), y};
    ring[quarter] = {x, std::ceil(y + reach)};
    ring[2 * quarter] = {x - std::floor(reach), y};
    ring[3 * quarter] = {x, y - std::floor(reach)};
    return ring;
}

/// A star in a square of this side, which its corners reach on all four, with three stars as holes and an island in
/// one of them. About `corners` corners in all.
inline PlaneRegion star_with_holes(std::uint32_t seed, int corners, double side)
{
    std::mt19937 random(seed);
    const double scale = 0x1p31 - 1, middle = std::floor(scale / 2);
    PlaneRegion region;
    region.polygons.push_back({star(random, corners * 3 / 4, middle, middle, 0.30 * scale, 0.49 * scale, scale / 2)});
    const int part = std::max(4, corners / 16);
    for (const auto& [dx, dy] : {std::pair{-0.12, -0.1}, {0.13, -0.08}, {0.0, 0.15}})
        region.polygons[0].holes.push_back(star(random, part, std::round(middle + dx * scale),
                                                std::round(middle + dy * scale), 0.03 * scale, 0.08 * scale));
    region.polygons.push_back(
        {star(random, part, middle, std::round(middle + 0.15 * scale), 0.008 * scale, 0.018 * scale)});
    if (side == scale) return region;
    const auto shrink = [&](RegionRing& ring) {
        for (auto& corner : ring)
            for (double& c : corner) c *= side / scale;
    };
    for (RegionPolygon& polygon : region.polygons) {
        shrink(polygon.outline);
        std::ranges::for_each(polygon.holes, shrink);
    }
    return region;
}

}
