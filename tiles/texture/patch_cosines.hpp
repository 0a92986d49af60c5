// Cosine transforms of all square patches of a picture on a grid, at chosen frequencies.
#pragma once

#include "base/images/png_file.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

/// A frequency of the cosine transform of a channel: u along rows, v along columns.
struct PatchFrequency
{
    int channel = 0;
    int u = 0;
    int v = 0;
};

/// Numbers of patches whose upper left pixels lie on a grid, row by row, so many a patch.
struct PatchGrid
{
    int columns = 0;
    int rows = 0;
    std::size_t numbers = 0;
    std::vector<float> values;

    std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
    std::span<const float> at(std::size_t i) const { return std::span(values).subspan(i * numbers, numbers); }
};

/// A picture of three channels as planes of orthonormal ones: (R + G + B) / sqrt 3, (R - B) / sqrt 2,
/// (R - 2 G + B) / sqrt 6; of one channel, that. Exemplars have one or three, others are not handled.
struct OpponentPlanes
{
    int width = 0;
    int height = 0;
    std::vector<std::vector<float>> planes;

    explicit OpponentPlanes(const PngPixels& picture);
    const float* row(int channel, int y) const
    {
        return &planes[static_cast<std::size_t>(channel)]
                      [static_cast<std::size_t>(y) * static_cast<std::size_t>(width)];
    }
};

/// Orthonormal cosines of patches of side x side pixels.
class PatchCosines
{
public:
    PatchCosines(int side, int frequencies);

    /// Coefficients at these frequencies of the patches at multiples of `step`; fast where those with the same channel
    /// and u stand side by side. On any number of threads the same bits.
    PatchGrid grid(const OpponentPlanes& picture, int step, std::span<const PatchFrequency> frequencies) const;

private:
    float cosine(int u, int i) const { return cosines_[static_cast<std::size_t>(u * side_ + i)]; }
    std::vector<float> filtered_rows(const OpponentPlanes& picture, const PatchFrequency& of, int step,
                                     int columns) const;
    void add_row(const std::vector<float>& rows, int v, int row, int step, std::size_t number, PatchGrid& grid) const;

    int side_;
    std::vector<float> cosines_; ///< by frequency and pixel
};

}
