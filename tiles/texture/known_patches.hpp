// Patches that are known, and how far the nearest one is. They stand in blocks of similar ones, which are the leaves of
// a tree of boxes (Friedman, Bentley, Finkel, An algorithm for finding best matches in logarithmic expected time,
// 1977). In a block, a coefficient of all patches follows the one before, so that the processor takes several patches
// at once.
//
// Cosine transforms of all square patches of a picture on a grid, at chosen frequencies.
#pragma once

#include "base/images/png_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace poissonlab {

/// Patches of equally many coefficients, at least head_coefficients; those that vary most come first.
class KnownPatches
{
public:
    KnownPatches() = default;
    explicit KnownPatches(std::vector<std::span<const float>> patches) { add_box(patches); }

    /// Returns the squared distance of the nearest patch. Sums round as those of two parts, the first coefficients and
    /// the rest, and sums of fewer or smaller terms are never above them.
    float nearest_distance(std::span<const float> patch) const
    {
        float least = std::numeric_limits<float>::infinity();
        search(0, patch, 0, least);
        return least;
    }

    /// Returns true if a patch is not farther than a squared distance.
    bool has_near(std::span<const float> patch, float distance) const
    {
        float least = std::nextafter(distance, std::numeric_limits<float>::infinity());
        search(0, patch, distance, least);
        return least <= distance;
    }

private:
    /// The coefficients by which boxes are bounded: most patches are far enough by them alone.
    static constexpr std::size_t head_coefficients = 8;
    static constexpr std::size_t block_size = 64;
    using Numbers = std::array<float, block_size>;

    /// A part of the patches; its first part is the next box.
    struct Box
    {
        std::array<float, head_coefficients> low, high; ///< of the first coefficients
        std::size_t second = 0;                         ///< the box of its second part; 0: it is a block
        std::size_t values = 0;                         ///< of the block: where its first value stands

        /// Returns a number that the squared distance of no patch in the box is below.
        float distance(std::span<const float> patch) const
        {
            float sum = 0;
            for (std::size_t k = 0; k < head_coefficients; ++k) {
                const float apart = std::max(std::max(low[k] - patch[k], patch[k] - high[k]), 0.0F);
                sum += apart * apart;
            }
            return sum;
        }
    };

    /// Adds the box of some patches and what is in it. Halves are those by the coefficient that varies most.
    void add_box(std::span<std::span<const float>> patches)
    {
        Box box;
        std::size_t widest = 0;
        for (std::size_t k = 0; k < head_coefficients; ++k) {
            const auto value = [k](std::span<const float> patch) { return patch[k]; };
            const auto [least, most] = std::ranges::minmax(patches, {}, value);
            box.low[k] = least[k];
            box.high[k] = most[k];
            if (box.high[k] - box.low[k] > box.high[widest] - box.low[widest]) widest = k;
        }
        const std::size_t place = boxes_.size();
        box.values = values_.size();
        boxes_.push_back(box);
        if (patches.size() <= block_size) return add_block(patches);
        const std::size_t blocks = (patches.size() + block_size - 1) / block_size, half = blocks / 2 * block_size;
        std::ranges::nth_element(patches, patches.begin() + static_cast<std::ptrdiff_t>(half), {},
                                 [widest](std::span<const float> patch) { return patch[widest]; });
        add_box(patches.first(half));
        boxes_[place].second = boxes_.size();
        add_box(patches.subspan(half));
    }

    /// Numbers after those of the last patch are infinite.
    void add_block(std::span<const std::span<const float>> patches)
    {
        for (std::size_t k = 0; k < patches[0].size(); ++k)
            for (std::size_t j = 0; j < block_size; ++j)
                values_.push_back(j < patches.size() ? patches[j][k] : std::numeric_limits<float>::infinity());
    }

    /// Makes `least` the least of itself and of the squared distances in a box; any that is at most `enough` will do.
    void search(std::size_t place, std::span<const float> patch, float enough, float& least) const
    {
        const Box& box = boxes_[place];
        if (box.second == 0) {
            least = std::min(least, least_in_block(&values_[box.values], patch, least));
            return;
        }
        std::array<std::pair<float, std::size_t>, 2> parts{std::pair{boxes_[place + 1].distance(patch), place + 1},
                                                           std::pair{boxes_[box.second].distance(patch), box.second}};
        if (parts[1].first < parts[0].first) std::swap(parts[0], parts[1]);
        for (const auto& [distance, part] : parts)
            if (distance < least && least > enough) search(part, patch, enough, least);
    }

    /// Adds the terms of coefficients from `first` up to `end` to the sums of a block's patches.
    static void add_terms(const float* block, std::span<const float> patch, std::size_t first, std::size_t end,
                          Numbers& sums)
    {
        for (std::size_t k = first; k < end; ++k) {
            const float* const values = block + k * block_size;
            const float value = patch[k];
            for (std::size_t j = 0; j < block_size; ++j) sums[j] += (values[j] - value) * (values[j] - value);
        }
    }

    /// Returns the least squared distance in a block, or a number that is not below `limit`.
    static float least_in_block(const float* block, std::span<const float> patch, float limit)
    {
        Numbers heads{}, tails{};
        add_terms(block, patch, 0, head_coefficients, heads);
        float least = std::ranges::min(heads);
        for (std::size_t k = head_coefficients; k < patch.size() && least < limit; k += head_coefficients) {
            add_terms(block, patch, k, std::min(k + head_coefficients, patch.size()), tails);
            least = heads[0] + tails[0];
            for (std::size_t j = 1; j < block_size; ++j) least = std::min(least, heads[j] + tails[j]);
        }
        return least;
    }

    std::vector<Box> boxes_;
    std::vector<float> values_; ///< of blocks
};

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
