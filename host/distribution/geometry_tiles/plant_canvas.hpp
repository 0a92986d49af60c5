// The colours of fields of plants, and rows of samples on which they are drawn.
#pragma once

#include "host/distribution/geometry_tiles/plant_model.hpp"
#include "host/distribution/geometry_tiles/triangle_fill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace poissonlab {

inline constexpr double least_depth = 0.05; ///< tiles before the camera from which on things are drawn
inline constexpr int ground_cells = 4;      ///< along a tile's side

/// The colours of levels of detail, from the finest.
inline constexpr std::array<ScreenColor, 8> plant_level_colors{{{0.85F, 0.1F, 0.1F},
                                                                {0.95F, 0.75F, 0.1F},
                                                                {0.3F, 0.75F, 0.2F},
                                                                {0.1F, 0.65F, 0.75F},
                                                                {0.25F, 0.35F, 0.9F},
                                                                {0.65F, 0.25F, 0.85F},
                                                                {0.95F, 0.5F, 0.15F},
                                                                {0.5F, 0.5F, 0.5F}}};

inline ScreenColor blend(const ScreenColor& a, const ScreenColor& b, double part)
{
    ScreenColor color{};
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<float>(static_cast<double>(a[i]) +
                                      part * (static_cast<double>(b[i]) - static_cast<double>(a[i])));
    return color;
}

/// Rows of samples, with the nearest depth where something is hidden by it.
struct PlantCanvas
{
    int columns, first_row, last_row;
    std::vector<ScreenColor> colors;
    std::vector<float> depths;

    PlantCanvas(int width, int first, int last)
        : columns(width), first_row(first), last_row(last),
          colors(static_cast<std::size_t>(width) * static_cast<std::size_t>(last - first)),
          depths(colors.size(), INFINITY)
    {}

    std::size_t at(int column, int row) const
    {
        return static_cast<std::size_t>(row - first_row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }

    /// A triangle of corners with column, row and depth, where nothing nearer is; `color` is called with weights.
    template <class Color>
    void triangle(const std::array<MeshPoint, 3>& c, Color color)
    {
        if (std::min({c[0][2], c[1][2], c[2][2]}) < least_depth) return;
        fill_triangle({{{c[0][0], c[0][1]}, {c[1][0], c[1][1]}, {c[2][0], c[2][1]}}}, {columns, first_row, last_row},
                      [&](int column, int row, std::array<double, 3> w) {
                          double sum = 0; // weights in space: those of the picture over depths
                          for (std::size_t i = 0; i < 3; ++i) sum += w[i] /= c[i][2];
                          const double depth = 1 / sum;
                          const std::size_t place = at(column, row);
                          if (depth >= static_cast<double>(depths[place])) return;
                          for (double& weight : w) weight *= depth;
                          depths[place] = static_cast<float>(depth);
                          colors[place] = color(w, depth);
                      });
    }
};

}
