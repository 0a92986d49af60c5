#include "tiles/texture/patch_novelty.hpp"

#include "tiles/texture/known_patches.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace poissonlab {
namespace {

/// Patches along the longer side of a half whose distances say what is near, and the most along the other one.
constexpr int natural_patches = 32;

std::vector<PatchFrequency> all_frequencies(int channels, int side)
{
    std::vector<PatchFrequency> all;
    const int most = std::min(side, patch_frequencies);
    for (int channel = 0; channel < channels; ++channel)
        for (int u = 0; u < most; ++u)
            for (int v = 0; v < most; ++v) all.push_back({channel, u, v});
    return all;
}

double coefficient_variance(const PatchGrid& grid, std::size_t number)
{
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const double value = grid.at(i)[number];
        sum += value;
        squares += value * value;
    }
    const auto count = static_cast<double>(grid.size());
    return squares / count - sum / count * (sum / count);
}

float coefficient_distance(const float* one, const float* other, std::size_t count)
{
    float sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += (one[i] - other[i]) * (one[i] - other[i]);
    return sum;
}

/// Returns true if the pixels of a patch lie side by side in the exemplar as they do in the tiling.
bool is_whole_patch(std::span<const SourcePixel> sources, int width, int left, int top, int side)
{
    const auto source = [&](int x, int y) { return sources[static_cast<std::size_t>(y * width + x)]; };
    const SourcePixel first = source(left, top);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (const SourcePixel here = source(left + x, top + y); here.x - first.x != x || here.y - first.y != y)
                return false;
    return true;
}

}

struct PatchNovelty::Parts
{
    Parts(const PngPixels& exemplar, int patch_side) : side(patch_side), cosines(patch_side, patch_frequencies)
    {
        const OpponentPlanes picture(exemplar);
        const auto patches = [&](int step) {
            return static_cast<std::size_t>((exemplar.width - side) / step + 1) *
                   static_cast<std::size_t>((exemplar.height - side) / step + 1);
        };
        while (patches(step) > most_known_patches) ++step;
        choose_frequencies(picture);
        grid = cosines.grid(picture, step, frequencies);
        sort_numbers(grid);
        std::vector<std::span<const float>> all;
        for (std::size_t i = 0; i < grid.size(); ++i) all.push_back(grid.at(i));
        known = KnownPatches(std::move(all));
        threshold = natural_threshold(exemplar.width, exemplar.height);
    }

    /// Takes those that vary most, by the patches at every few pixels, and sorts them by channel and u.
    void choose_frequencies(const OpponentPlanes& picture)
    {
        frequencies = all_frequencies(static_cast<int>(picture.planes.size()), side);
        const PatchGrid sparse = cosines.grid(picture, std::max(1, side / 4), frequencies);
        std::vector<double> variances;
        for (std::size_t k = 0; k < frequencies.size(); ++k) variances.push_back(coefficient_variance(sparse, k));
        std::vector<std::size_t> order(frequencies.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return variances[k]; });
        order.resize(std::min(order.size(), patch_coefficients));
        std::vector<std::size_t> sorted = order;
        std::ranges::sort(sorted);
        std::vector<PatchFrequency> chosen;
        for (const std::size_t k : sorted) chosen.push_back(frequencies[k]);
        for (const std::size_t k : order)
            places.push_back(static_cast<std::size_t>(std::ranges::find(sorted, k) - sorted.begin()));
        frequencies = std::move(chosen);
    }

    /// Puts the coefficients that vary most first.
    void sort_numbers(PatchGrid& unsorted) const
    {
        std::vector<float> patch(unsorted.numbers);
        for (std::size_t i = 0; i < unsorted.size(); ++i) {
            float* const values = &unsorted.values[i * unsorted.numbers];
            for (std::size_t k = 0; k < patch.size(); ++k) patch[k] = values[places[k]];
            std::ranges::copy(patch, values);
        }
    }

    PatchGrid sorted_grid(const PngPixels& picture, int picture_step) const
    {
        PatchGrid found = cosines.grid(OpponentPlanes(picture), picture_step, frequencies);
        sort_numbers(found);
        return found;
    }

    /// Returns the squared distance that a share of natural_novelty of the patches exceeds, measured from each half to
    /// the other half.
    float natural_threshold(int width, int height) const
    {
        const bool is_wide = width >= height;
        const int longer = is_wide ? width : height, half = longer / 2;
        std::array<std::vector<std::size_t>, 2> halves;
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const int from = (is_wide ? column : row) * step;
                if (from + side <= half) halves[0].push_back(grid.index(column, row));
                if (from >= longer - half) halves[1].push_back(grid.index(column, row));
            }
        std::vector<float> distances;
        for (const std::size_t one : {std::size_t{0}, std::size_t{1}}) {
            std::vector<std::span<const float>> opposite;
            for (const std::size_t i : halves[1 - one]) opposite.push_back(grid.at(i));
            const KnownPatches others(std::move(opposite));
            const std::vector<std::size_t> asked = sparse(halves[one]);
            const std::size_t first = distances.size();
            distances.resize(first + asked.size());
            tbb::parallel_for(std::size_t{0}, asked.size(), [&](std::size_t i) {
                distances[first + i] = others.nearest_distance(grid.at(asked[i]));
            });
        }
        std::ranges::sort(distances);
        const auto known_count =
            static_cast<std::size_t>((1 - natural_novelty) * static_cast<double>(distances.size()));
        return distances[std::min(known_count, distances.size()) - 1];
    }

    /// Returns those patches of a half whose rows and columns are a step apart; the step keeps their number small.
    std::vector<std::size_t> sparse(const std::vector<std::size_t>& patches) const
    {
        const auto columns = static_cast<std::size_t>(grid.columns);
        const int apart = std::max(1, std::max(grid.columns, grid.rows) / natural_patches);
        std::vector<std::size_t> chosen;
        for (const std::size_t i : patches)
            if (static_cast<int>(i % columns) % apart == 0 && static_cast<int>(i / columns) % apart == 0)
                chosen.push_back(i);
        return chosen;
    }

    /// True if one of the patches from which a patch's pixels come is near it: a short way to most answers.
    bool is_near_its_sources(std::span<const float> patch, std::span<const SourcePixel> sources, int width, int left,
                             int top) const
    {
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) {
                const int x = i * (side - 1) / 2, y = j * (side - 1) / 2;
                const SourcePixel source = sources[static_cast<std::size_t>((top + y) * width + left + x)];
                const int column = std::clamp((source.x - x + step / 2) / step, 0, grid.columns - 1),
                          row = std::clamp((source.y - y + step / 2) / step, 0, grid.rows - 1);
                if (coefficient_distance(patch.data(), grid.at(grid.index(column, row)).data(), patch.size()) <=
                    threshold)
                    return true;
            }
        return false;
    }

    bool is_new(std::span<const float> patch, std::span<const SourcePixel> sources, int width, int left, int top) const
    {
        if (!sources.empty() &&
            (is_whole_patch(sources, width, left, top, side) || is_near_its_sources(patch, sources, width, left, top)))
            return false;
        return !known.has_near(patch, threshold);
    }

    int side;
    int step = 1; ///< of the grid of known patches
    PatchCosines cosines;
    std::vector<PatchFrequency> frequencies;
    std::vector<std::size_t> places; ///< of coefficients, the one that varies most first
    PatchGrid grid;
    KnownPatches known;
    float threshold = 0;
};

PatchNovelty::PatchNovelty(const PngPixels& exemplar, int side) : parts_(std::make_unique<Parts>(exemplar, side)) {}
PatchNovelty::~PatchNovelty() = default;
PatchNovelty::PatchNovelty(PatchNovelty&&) noexcept = default;

double PatchNovelty::threshold() const { return parts_->threshold; }

double PatchNovelty::share(const PngPixels& picture, int step, std::span<const SourcePixel> sources) const
{
    const PatchGrid asked = parts_->sorted_grid(picture, step);
    std::vector<std::uint8_t> is_new(asked.size());
    tbb::parallel_for(0, asked.rows, [&](int row) {
        for (int column = 0; column < asked.columns; ++column) {
            const std::size_t i = asked.index(column, row);
            is_new[i] = parts_->is_new(asked.at(i), sources, picture.width, column * step, row * step);
        }
    });
    return static_cast<double>(std::ranges::count(is_new, 1)) / static_cast<double>(is_new.size());
}

bool patch_fits(const PngPixels& exemplar, int side) { return std::min(exemplar.width, exemplar.height) >= 4 * side; }

}
