#include "tiles/texture/tiling_judge.hpp"

#include "tiles/texture/square_means.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace poissonlab {
namespace {

/// The tiling that is judged has about judged_pixels along each side, in whole tiles, at least four; about
/// judged_patches patches along each side are compared.
constexpr int judged_pixels = 1024, judged_patches = 128;

int odd(int side) { return side / 2 * 2 + 1; }

/// Returns the root of a pixel's part, and shortens the path to it.
std::size_t root_of(std::vector<std::size_t>& parents, std::size_t i)
{
    while (parents[i] != i) i = parents[i] = parents[parents[i]];
    return i;
}

bool is_step(SourcePixel from, SourcePixel to, int dx, int dy) { return to.x - from.x == dx && to.y - from.y == dy; }

std::vector<SourcePixel> window_sources(const TextureSet& set, const TextureWindow& window)
{
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(set.sources.data());
    const PngPixels shown =
        texture_window_pixels(set, window, {bytes, set.sources.size() * sizeof(SourcePixel)}, sizeof(SourcePixel));
    std::vector<SourcePixel> sources(shown.values.size() / sizeof(SourcePixel));
    std::memcpy(sources.data(), shown.values.data(), shown.values.size());
    return sources;
}

}

int feature_side(const PngPixels& exemplar)
{
    const SquareMeans means(channel_sums(exemplar), exemplar.width);
    const double pixels = means.variance(1);
    if (!(pixels > 0)) return 1;
    const std::optional<double> side = means.side_of_variance(pixels / 2);
    return side ? static_cast<int>(std::ceil(*side)) : std::max(1, std::min(exemplar.width, exemplar.height) / 2);
}

std::size_t small_fragments(std::span<const SourcePixel> sources, int width, std::size_t pixels)
{
    const auto columns = static_cast<std::size_t>(width), rows = sources.size() / columns;
    std::vector<std::size_t> parents(sources.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const auto join = [&](std::size_t other, int dx, int dy) {
            if (is_step(sources[i], sources[other], dx, dy)) parents[root_of(parents, other)] = root_of(parents, i);
        };
        if (i % columns + 1 < columns) join(i + 1, 1, 0);
        if (i / columns + 1 < rows) join(i + columns, 0, 1);
    }
    std::vector<std::size_t> sizes(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::size_t x = i % columns, y = i / columns;
        const bool is_beside_border = x == 0 || y == 0 || x + 1 == columns || y + 1 == rows;
        sizes[root_of(parents, i)] += is_beside_border ? pixels : 1;
    }
    return static_cast<std::size_t>(
        std::ranges::count_if(sizes, [&](std::size_t size) { return size > 0 && size < pixels; }));
}

TilingJudge::TilingJudge(const PngPixels& exemplar, int size, bool has_all_sides)
    : exemplar_(exemplar), size_(size),
      feature_(feature_side(exemplar)), sides_{odd(std::clamp(feature_, 7, judged_patch / 2)), judged_patch,
                                               odd(std::clamp(3 * feature_, 41, 81))}
{
    for (std::size_t i = 0; i < sides_.size(); ++i)
        if (patch_fits(exemplar, sides_[i]) && (has_all_sides || sides_[i] == judged_patch))
            patches_[i].emplace(exemplar, sides_[i]);
}

TilingJudgement TilingJudge::judge(const TextureSet& set, std::uint64_t seed) const
{
    const auto tiles = static_cast<std::uint64_t>(std::clamp(judged_pixels / size_, 4, 16));
    const TextureWindow window = texture_window(set, {0, 0, tiles, tiles}, seed);
    const PngPixels picture = texture_window_pixels(set, window, set.values, set.exemplar.channels);
    const std::vector<SourcePixel> sources = window_sources(set, window);
    TilingJudgement found;
    found.feature = feature_;
    found.sides = sides_;
    const int step = std::max(1, picture.width / judged_patches);
    for (std::size_t i = 0; i < sides_.size(); ++i)
        if (patches_[i])
            found.novelty[i] = set.is_smoothed || set.is_changed() ? patches_[i]->share(picture, 2 * step)
                                                                   : patches_[i]->share(picture, step, sources);
    found.slow = slow_powers(picture, exemplar_, size_);
    if (2 * feature_ > size_) return found;
    const auto area = static_cast<std::size_t>(feature_) * static_cast<std::size_t>(feature_);
    found.fragments =
        static_cast<double>(small_fragments(sources, picture.width, area)) / static_cast<double>(window.tiles.size());
    return found;
}

std::optional<TilingJudgement> judged_tiling(const TextureSet& set, std::uint64_t seed)
{
    if (set.classes > 1) return std::nullopt;
    return TilingJudge(set.exemplar, set.size).judge(set, seed);
}

}
