#include "host/texture/tile_levels.hpp"

#include "host/texture/joint/square_form.hpp"
#include "tiles/texture/square_means.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

/// From so many times the exemplar's variance on, a tiling is levelled.
constexpr double most_times = 1.1;

SetParts parts_of(const TextureSet& set)
{
    TextureRequest request;
    request.kind = set.kind;
    request.colors = set.colors;
    return set_parts(request, set.tiles);
}

/// The means of a channel without their own mean.
Quarters quarters_of(const TextureSet& set, std::span<const double> shown, std::size_t channel)
{
    const auto size = static_cast<std::size_t>(set.size), channels = static_cast<std::size_t>(set.exemplar.channels);
    Quarters means(set.tiles.size(), {0, 0, 0, 0});
    for (std::size_t i = channel; i < shown.size(); i += channels) {
        const std::size_t pixel = i / channels, x = pixel % size, y = pixel / size % size;
        means[pixel / size / size][2 * (2 * y / size) + 2 * x / size] += shown[i];
    }
    double sum = 0;
    for (auto& tile : means)
        for (double& mean : tile) sum += mean /= static_cast<double>(size * size) / 4;
    for (auto& tile : means)
        for (double& mean : tile) mean -= sum / (4 * static_cast<double>(means.size()));
    return means;
}

Quarters all_quarters(const TextureSet& set, std::span<const double> shown)
{
    Quarters sums(set.tiles.size(), {0, 0, 0, 0});
    for (std::size_t c = 0; c < static_cast<std::size_t>(set.exemplar.channels); ++c)
        add_times(sums, 1, quarters_of(set, shown, c));
    return sums;
}

/// The variance of the sums over channels of what a set shows.
double pixel_variance(std::span<const double> shown, std::size_t channels)
{
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < shown.size(); i += channels) {
        const double pixel = std::accumulate(&shown[i], &shown[i] + channels, 0.0);
        sum += pixel;
        squares += pixel * pixel;
    }
    const double count = static_cast<double>(shown.size() / channels);
    return squares / count - sum / count * (sum / count);
}

/// The variance of all squares of an exemplar over the variance of its pixels.
double exemplar_share(const PngPixels& exemplar, int size)
{
    const SquareMeans means(channel_sums(exemplar), exemplar.width);
    const double pixels = means.variance(1);
    return pixels > 0 ? means.variance(size) / pixels : 0;
}

/// The largest weight of the field's square that leaves at most the variance `most`: between 1e-3, with which nearly
/// all is gone that can be, and 1e3, with which the field is nearly 0. The variance of the sum of channels counts, and
/// grows with the weight.
double weight_for(const SquareForm& form, const Quarters& quarters, double most)
{
    double low = std::log(1e-3), high = std::log(1e3);
    for (int step = 0; step < 30; ++step) {
        const double middle = (low + high) / 2;
        Quarters levelled = quarters;
        add_times(levelled, 1, form.field(form.best_heights(quarters, std::exp(middle))));
        (product(levelled, form.applied(levelled)) <= most ? low : high) = middle;
    }
    return std::exp(low);
}

}

bool SquareVariances::is_uneven() const { return is_known && tiling > most_times * exemplar; }

SquareVariances square_variances(const TextureSet& set)
{
    const SetParts parts = parts_of(set);
    const std::vector<double> shown(set.values.begin(), set.values.end());
    const Quarters quarters = all_quarters(set, shown);
    const double squares = product(quarters, SquareForm(parts, set.size, set.ring).applied(quarters)),
                 pixels = pixel_variance(shown, static_cast<std::size_t>(set.exemplar.channels));
    return {exemplar_share(set.exemplar, set.size), pixels > 0 ? squares / pixels : 0,
            std::min(set.exemplar.width, set.exemplar.height) >= 4 * set.size};
}

std::vector<double> level_changes(const TextureSet& set, std::span<const double> shown)
{
    const SetParts parts = parts_of(set);
    const SquareForm form(parts, set.size, set.ring);
    const auto channels = static_cast<std::size_t>(set.exemplar.channels);
    const double most = exemplar_share(set.exemplar, set.size) * pixel_variance(shown, channels);
    const double weight = weight_for(form, all_quarters(set, shown), most);
    std::vector<std::vector<double>> heights;
    for (std::size_t c = 0; c < channels; ++c) heights.push_back(form.best_heights(quarters_of(set, shown, c), weight));
    std::vector<double> changes;
    changes.reserve(shown.size());
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile)
        for (int y = 0; y < set.size; ++y)
            for (int x = 0; x < set.size; ++x) {
                const double across = middle_at(x, set.size, set.ring), down = middle_at(y, set.size, set.ring);
                const std::size_t quarter = (2 * y < set.size ? 0u : 2u) + (2 * x < set.size ? 0u : 1u);
                const std::array<std::size_t, 4> hats = form.hats_at(tile, quarter);
                for (std::size_t c = 0; c < channels; ++c) {
                    const double north = (1 - across) * heights[c][hats[0]] + across * heights[c][hats[2]],
                                 middle = (1 - across) * heights[c][hats[1]] + across * heights[c][hats[3]];
                    changes.push_back((1 - down) * north + down * middle);
                }
            }
    return changes;
}

}
