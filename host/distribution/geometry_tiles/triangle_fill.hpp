// The pixels whose middles are in a triangle, for pictures of plants in parallel and in perspective projection.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {

/// A corner in pixels from the picture's corner.
struct FillCorner
{
    double x = 0, y = 0;
};

/// Columns and rows of pixels, without the last ones.
struct FillArea
{
    int columns = 0, first_row = 0, last_row = 0;
};

/// Calls paint(column, row, weights) with the weights of the corners, whose sum is 1, for the area's pixels whose
/// middle is in the triangle or on its border.
template <class Paint>
void fill_triangle(const std::array<FillCorner, 3>& c, const FillArea& area, Paint paint)
{
    const double twice_area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
    if (twice_area == 0) return;
    const auto [x_low, x_high] = std::minmax({c[0].x, c[1].x, c[2].x});
    const auto [y_low, y_high] = std::minmax({c[0].y, c[1].y, c[2].y});
    if (!(x_high > 0 && x_low < area.columns && y_high > area.first_row && y_low < area.last_row)) return;
    const int first_column = static_cast<int>(std::max(0.0, std::ceil(x_low - 0.5)));
    const int last_column = static_cast<int>(std::min(area.columns - 1.0, std::floor(x_high - 0.5)));
    const int first_row = static_cast<int>(std::max<double>(area.first_row, std::ceil(y_low - 0.5)));
    const int last_row = static_cast<int>(std::min(area.last_row - 1.0, std::floor(y_high - 0.5)));
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column) {
            const double x = column + 0.5, y = row + 0.5;
            const double a = ((c[1].x - x) * (c[2].y - y) - (c[2].x - x) * (c[1].y - y)) / twice_area;
            const double b = ((c[2].x - x) * (c[0].y - y) - (c[0].x - x) * (c[2].y - y)) / twice_area;
            if (a >= 0 && b >= 0 && a + b <= 1) paint(column, row, std::array<double, 3>{a, b, 1 - a - b});
        }
}

}
