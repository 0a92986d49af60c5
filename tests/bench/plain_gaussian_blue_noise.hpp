// Gaussian blue noise as one would write it at once: plain, sequential, in single precision, with a cell grid.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace poissonlab::bench {

struct PlainPoint
{
    float x, y; ///< in mean distances
};

/// A step of all points on a torus with a side of sqrt(points) mean distances; sigma is one of these.
inline void plain_gaussian_step(std::vector<PlainPoint>& points, float step)
{
    constexpr float cut = 5.8F;
    const float side = std::sqrt(static_cast<float>(points.size()));
    const int cells = static_cast<int>(side / cut * 2);
    const auto cell_of = [&](float c) {
        return std::min(static_cast<int>(c / side * static_cast<float>(cells)), cells - 1);
    };
    std::vector<std::vector<PlainPoint>> grid(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    const auto at = [&](int x, int y) -> std::vector<PlainPoint>& {
        return grid[static_cast<std::size_t>((y + cells) % cells * cells + (x + cells) % cells)];
    };
    for (const PlainPoint& p : points) at(cell_of(p.x), cell_of(p.y)).push_back(p);
    const auto shortest = [&](float d) { return d > side / 2 ? d - side : d < -side / 2 ? d + side : d; };
    const auto wrapped = [&](float c) { return c < 0 ? c + side : c >= side ? c - side : c; };
    for (PlainPoint& p : points) {
        float force_x = 0, force_y = 0;
        for (int y = -2; y <= 2; ++y)
            for (int x = -2; x <= 2; ++x)
                for (const PlainPoint& q : at(cell_of(p.x) + x, cell_of(p.y) + y)) {
                    const float dx = shortest(q.x - p.x), dy = shortest(q.y - p.y);
                    const float squared = dx * dx + dy * dy;
                    if (squared >= cut * cut) continue;
                    const float gaussian = std::exp(-squared / 2);
                    force_x -= dx * gaussian;
                    force_y -= dy * gaussian;
                }
        p.x = wrapped(p.x + step * force_x);
        p.y = wrapped(p.y + step * force_y);
    }
}

}
