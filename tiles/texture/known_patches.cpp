#include "tiles/texture/known_patches.hpp"

#include <tbb/parallel_for.h>

#include <cstdint>
#include <numbers>

namespace poissonlab {

OpponentPlanes::OpponentPlanes(const PngPixels& picture)
    : width(picture.width), height(picture.height), planes(static_cast<std::size_t>(picture.channels))
{
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::vector<float>& plane : planes) plane.reserve(picture.values.size() / channels);
    for (std::size_t i = 0; i < picture.values.size(); i += channels) {
        const std::uint8_t* const v = &picture.values[i];
        if (channels == 1) {
            planes[0].push_back(v[0]);
            continue;
        }
        planes[0].push_back(static_cast<float>((v[0] + v[1] + v[2]) / std::sqrt(3.0)));
        planes[1].push_back(static_cast<float>((v[0] - v[2]) / std::sqrt(2.0)));
        planes[2].push_back(static_cast<float>((v[0] - 2 * v[1] + v[2]) / std::sqrt(6.0)));
    }
}

PatchCosines::PatchCosines(int side, int frequencies) : side_(side)
{
    // Rounded, so that the last bits of a library's cosine do not matter.
    constexpr double unit = 1 << 14;
    for (int u = 0; u < frequencies; ++u)
        for (int i = 0; i < side; ++i)
            cosines_.push_back(
                static_cast<float>(std::round(unit * std::sqrt((u == 0 ? 1.0 : 2.0) / side) *
                                              std::cos(std::numbers::pi * u * (2 * i + 1) / (2.0 * side))) /
                                   unit));
}

PatchGrid PatchCosines::grid(const OpponentPlanes& picture, int step, std::span<const PatchFrequency> frequencies) const
{
    PatchGrid grid{(picture.width - side_) / step + 1, (picture.height - side_) / step + 1, frequencies.size(), {}};
    grid.values.resize(grid.size() * grid.numbers);
    for (std::size_t first = 0; first < frequencies.size();) {
        const PatchFrequency& of = frequencies[first];
        std::size_t end = first + 1;
        while (end < frequencies.size() && frequencies[end].channel == of.channel && frequencies[end].u == of.u) ++end;
        const std::vector<float> rows = filtered_rows(picture, of, step, grid.columns);
        tbb::parallel_for(0, grid.rows, [&](int row) {
            for (std::size_t k = first; k < end; ++k) add_row(rows, frequencies[k].v, row, step, k, grid);
        });
        first = end;
    }
    return grid;
}

/// For each row of the picture the sums along it, at each column of the grid.
std::vector<float> PatchCosines::filtered_rows(const OpponentPlanes& picture, const PatchFrequency& of, int step,
                                               int columns) const
{
    std::vector<float> rows(static_cast<std::size_t>(picture.height) * static_cast<std::size_t>(columns));
    tbb::parallel_for(0, picture.height, [&](int y) {
        const float* const from = picture.row(of.channel, y);
        float* const to = &rows[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns)];
        for (int i = 0; i < side_; ++i) {
            const float weight = cosine(of.u, i);
            for (int x = 0; x < columns; ++x) to[x] += weight * from[x * step + i];
        }
    });
    return rows;
}

void PatchCosines::add_row(const std::vector<float>& rows, int v, int row, int step, std::size_t number,
                           PatchGrid& grid) const
{
    std::vector<float> sums(static_cast<std::size_t>(grid.columns));
    for (int i = 0; i < side_; ++i) {
        const float weight = cosine(v, i);
        const float* const from = &rows[static_cast<std::size_t>(row * step + i) * sums.size()];
        for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += weight * from[x];
    }
    for (int x = 0; x < grid.columns; ++x)
        grid.values[grid.index(x, row) * grid.numbers + number] = sums[static_cast<std::size_t>(x)];
}

}
