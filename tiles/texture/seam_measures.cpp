#include "tiles/texture/seam_measures.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

namespace poissonlab {
namespace {

/// One pixel to the east, or one to the south.
struct Step
{
    int x = 0;
    int y = 0;
};
constexpr std::array<Step, 2> steps{{{1, 0}, {0, 1}}};

/// The exemplar's own differences of neighbours in a direction.
struct NaturalSteps
{
    double mean = 0;
    int quantile = 0;  ///< at most 5 % are larger
    double larger = 0; ///< how many are, in parts of all
};

int difference(const PngPixels& exemplar, SourcePixel a, SourcePixel b)
{
    int sum = 0;
    for (int c = 0; c < exemplar.channels; ++c)
        sum += std::abs(exemplar.values[exemplar.at(a.x, a.y, c)] - exemplar.values[exemplar.at(b.x, b.y, c)]);
    return sum;
}

/// The source a step away, where the exemplar goes on.
std::optional<SourcePixel> beyond(const PngPixels& exemplar, SourcePixel source, int dx, int dy)
{
    const int x = source.x + dx, y = source.y + dy;
    if (x < 0 || y < 0 || x >= exemplar.width || y >= exemplar.height) return std::nullopt;
    return SourcePixel{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
}

NaturalSteps natural_steps(const PngPixels& exemplar, Step step)
{
    std::vector<int> all;
    std::int64_t sum = 0;
    for (int y = 0; y + step.y < exemplar.height; ++y)
        for (int x = 0; x + step.x < exemplar.width; ++x) {
            const SourcePixel here{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
            all.push_back(difference(exemplar, here, *beyond(exemplar, here, step.x, step.y)));
            sum += all.back();
        }
    std::ranges::sort(all);
    NaturalSteps natural;
    natural.mean = static_cast<double>(sum) / static_cast<double>(all.size());
    natural.quantile = all[(all.size() * 95 + 99) / 100 - 1];
    natural.larger = static_cast<double>(all.end() - std::ranges::upper_bound(all, natural.quantile)) /
                     static_cast<double>(all.size());
    return natural;
}

/// Sums over all seam pairs of a set.
class SeamSums
{
public:
    explicit SeamSums(const TextureSet& set)
        : set_(set), natural_{natural_steps(set.exemplar, steps[0]), natural_steps(set.exemplar, steps[1])}
    {}

    SeamMeasures measure()
    {
        line_pairs_.assign(2 * static_cast<std::size_t>(set_.size), 0);
        for (std::size_t tile = 0; tile < set_.tiles.size(); ++tile)
            for (std::size_t direction = 0; direction < 2; ++direction) add_tile(tile, direction);
        const auto mean = [](double sum, std::int64_t count) {
            return count == 0 ? 0 : sum / static_cast<double>(count);
        };
        return {static_cast<double>(pairs_) / static_cast<double>(set_.tiles.size()),
                mean(mismatch_, complete_pairs_),
                mean(excess_, complete_pairs_),
                mean(static_cast<double>(conspicuous_), pairs_),
                (natural_[0].larger + natural_[1].larger) / 2,
                longest_run_,
                line_share(pairs_) / (2 * (set_.size - 1)),
                line_share(*std::ranges::max_element(line_pairs_)),
                longest_line_,
                coverage()};
    }

private:
    /// Follows the lines between pixels, along which runs are straight.
    void add_tile(std::size_t tile, std::size_t direction)
    {
        const std::span<const SourcePixel> sources = set_.sources_of(tile);
        const auto source = [&](int across, int along) {
            const int x = direction == 0 ? across : along, y = direction == 0 ? along : across;
            return sources[static_cast<std::size_t>(y * set_.size + x)];
        };
        for (int across = 0; across + 1 < set_.size; ++across) {
            int run = 0, line = 0;
            for (int along = 0; along < set_.size; ++along) {
                const SourcePixel p = source(across, along), q = source(across + 1, along);
                line = is_seam(p, q, direction) ? line + 1 : 0;
                run = line > 0 && is_conspicuous(p, q, direction) ? run + 1 : 0;
                if (line > 0)
                    ++line_pairs_[direction * static_cast<std::size_t>(set_.size) + static_cast<std::size_t>(across)];
                longest_run_ = std::max(longest_run_, run);
                longest_line_ = std::max(longest_line_, line);
            }
        }
    }

    static bool is_seam(SourcePixel p, SourcePixel q, std::size_t direction)
    {
        return q.x - p.x != steps[direction].x || q.y - p.y != steps[direction].y;
    }

    /// The share of the pairs over a line that so many are.
    double line_share(std::int64_t pairs) const
    {
        return static_cast<double>(pairs) / (static_cast<double>(set_.tiles.size()) * set_.size);
    }

    /// Adds a seam pair.
    bool is_conspicuous(SourcePixel p, SourcePixel q, std::size_t direction)
    {
        const Step step = steps[direction];
        ++pairs_;
        const NaturalSteps& natural = natural_[direction];
        const int seam = difference(set_.exemplar, p, q);
        add_mismatch(p, q, seam, step, natural.mean);
        if (seam <= natural.quantile) return false;
        ++conspicuous_;
        return true;
    }

    void add_mismatch(SourcePixel p, SourcePixel q, int seam, Step step, double natural)
    {
        const auto a_goes_on = beyond(set_.exemplar, p, step.x, step.y);
        const auto b_comes_from = beyond(set_.exemplar, q, -step.x, -step.y);
        if (!a_goes_on || !b_comes_from || natural == 0) return;
        ++complete_pairs_;
        mismatch_ +=
            (difference(set_.exemplar, p, *b_comes_from) + difference(set_.exemplar, *a_goes_on, q)) / (2 * natural);
        const int own = std::max(difference(set_.exemplar, p, *a_goes_on), difference(set_.exemplar, *b_comes_from, q));
        excess_ += std::max(0, seam - own) / natural;
    }

    double coverage() const
    {
        std::vector<bool> is_shown(static_cast<std::size_t>(set_.exemplar.width) *
                                   static_cast<std::size_t>(set_.exemplar.height));
        for (const SourcePixel source : set_.sources)
            is_shown[static_cast<std::size_t>(source.y) * static_cast<std::size_t>(set_.exemplar.width) + source.x] =
                true;
        return static_cast<double>(std::ranges::count(is_shown, true)) / static_cast<double>(is_shown.size());
    }

    const TextureSet& set_;
    std::array<NaturalSteps, 2> natural_;
    std::int64_t pairs_ = 0, complete_pairs_ = 0, conspicuous_ = 0;
    double mismatch_ = 0, excess_ = 0;
    int longest_run_ = 0, longest_line_ = 0;
    std::vector<std::int64_t> line_pairs_; ///< seams over each line of both directions
};

}

SeamMeasures seam_measures(const TextureSet& set) { return SeamSums(set).measure(); }

}
