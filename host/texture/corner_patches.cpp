#include "host/texture/corner_patches.hpp"

#include "base/random/random.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {
namespace {

/// The misfit of patches where they meet at the middles of edges, along so many pixels, how far their mean colours are
/// from the exemplar's, and the power that their middles give a tiling at whole multiples of 1/T: the square of their
/// mean's difference from the exemplar's. Patches without contrast have little of it, and those that make up for each
/// other.
class PatchScore
{
public:
    PatchScore(const PngPixels& exemplar, int reach, int middle) : exemplar_(exemplar), reach_(reach), middle_(middle)
    {
        for (int c = 0; c < exemplar.channels; ++c) means_.push_back(mean({0, 0, 0}, c));
    }

    double operator()(const Patches& patches) const
    {
        double score = 0;
        for (const ExemplarWindow& first : patches) {
            for (const ExemplarWindow& second : patches) score += joint(first, second);
            const double pixels = 4.0 * reach_ * static_cast<double>(patches.size());
            for (int c = 0; c < exemplar_.channels; ++c)
                score += pixels * std::pow(mean(first, c) - means_[static_cast<std::size_t>(c)], 2);
        }
        return score + repeated_power(patches);
    }

private:
    /// The power of the patches' summed deviations from the mean over the pixels of the middles, as if each colour had
    /// an error of its own there.
    double repeated_power(const Patches& patches) const
    {
        double power = 0;
        const int half = patches[0].size / 2;
        for (int y = half - middle_; y < half + middle_; ++y)
            for (int x = half - middle_; x < half + middle_; ++x)
                for (int c = 0; c < exemplar_.channels; ++c) {
                    double sum = 0;
                    for (const ExemplarWindow& patch : patches)
                        sum += exemplar_.values[exemplar_.at(patch.x + x, patch.y + y, c)] -
                               means_[static_cast<std::size_t>(c)];
                    power += sum * sum / static_cast<double>(patches.size());
                }
        return power;
    }

    /// The mean of a channel over a window, or over the whole exemplar where the window's size is 0.
    double mean(const ExemplarWindow& window, int channel) const
    {
        const int width = window.size > 0 ? window.size : exemplar_.width;
        const int height = window.size > 0 ? window.size : exemplar_.height;
        std::int64_t sum = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) sum += exemplar_.values[exemplar_.at(window.x + x, window.y + y, channel)];
        return static_cast<double>(sum) / (static_cast<double>(width) * height);
    }

    /// Squared differences across the joint, of a vertical and a horizontal edge.
    double joint(const ExemplarWindow& first, const ExemplarWindow& second) const
    {
        const int half = first.size / 2;
        std::int64_t sum = 0;
        for (int i = half - reach_; i < half + reach_; ++i)
            for (int c = 0; c < exemplar_.channels; ++c) {
                const auto value = [&](const ExemplarWindow& window, int x, int y) {
                    return static_cast<int>(exemplar_.values[exemplar_.at(window.x + x, window.y + y, c)]);
                };
                const int north_south = value(first, i, first.size - 1) - value(second, i, 0);
                const int west_east = value(first, first.size - 1, i) - value(second, 0, i);
                sum += north_south * north_south + west_east * west_east;
            }
        return static_cast<double>(sum);
    }

    const PngPixels& exemplar_;
    int reach_;
    int middle_; ///< half of the side of what tiles show of a patch
    std::vector<double> means_;
};

bool is_marked_color(const TextureRequest& request, Color color)
{
    return request.classes() == 2 && color >= request.colors.horizontal / 2;
}

/// Half of the side of the square around a corner where tiles show its patch: with pieces around edges, up to these.
int shown_middle(const TextureRequest& request)
{
    return std::max(2, request.stages == 3 ? request.size / 5 : 3 * request.size / 8);
}

}

ExemplarWindow plain_window(const UsedWindows& used, const PngPixels& exemplar, ColumnRange columns,
                            const Salience& salience, int size, RandomWords& words)
{
    constexpr int most_draws = 50;
    ExemplarWindow plainest;
    double lowest = 2;
    for (int i = 0; i < most_draws && lowest > most_salience; ++i) {
        const ExemplarWindow window = used.draw(exemplar, columns, size, words);
        const double rank = salience.rank(window);
        if (rank >= lowest) continue;
        plainest = window;
        lowest = rank;
    }
    return plainest;
}

Patches chosen_patches(const PngPixels& exemplar, const TextureRequest& request, int distance)
{
    const int middle = shown_middle(request);
    const PatchScore score(exemplar, std::max(1, request.ring_pixels()), middle);
    std::vector<Salience> saliences; // of the exemplars of unmarked and of marked corners
    for (int marked = 0; marked < request.classes(); ++marked)
        saliences.emplace_back(exemplar, columns_of(exemplar, request.split, marked == 1), request.size, middle);
    Patches best;
    double best_score = 0;
    for (int attempt = 0; attempt < request.attempts; ++attempt) {
        RandomWords words(stream_key(request.seed, Purpose::texture_windows, 0, static_cast<std::uint32_t>(attempt)),
                          0);
        UsedWindows used(distance);
        for (Color color = 0; color < request.colors.horizontal; ++color) {
            const bool is_marked = is_marked_color(request, color);
            used.add(plain_window(used, exemplar, columns_of(exemplar, request.split, is_marked),
                                  saliences[is_marked ? 1 : 0], request.size, words));
        }
        const double its_score = score(used.windows());
        if (attempt > 0 && its_score >= best_score) continue;
        best = used.windows();
        best_score = its_score;
    }
    return best;
}

std::vector<ColumnRange> ranges_for(const PngPixels& exemplar, const TextureRequest& request,
                                    const std::vector<Color>& colors)
{
    if (request.classes() == 1) return {};
    const auto marked = std::ranges::count_if(colors, [&](Color color) { return is_marked_color(request, color); });
    const auto others = std::ssize(colors) - marked;
    std::vector<ColumnRange> ranges;
    if (others >= marked) ranges.push_back(columns_of(exemplar, request.split, false));
    if (marked >= others) ranges.push_back(columns_of(exemplar, request.split, true));
    return ranges;
}

}
