#include "host/texture/seam_blending.hpp"

#include "base/errors/errors.hpp"
#include "host/texture/joint/set_cover.hpp"
#include "host/texture/tile_levels.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace poissonlab {
namespace {

/// The least squares over the pixels of a cover, each of which is one unknown a channel.
class SeamProblem
{
public:
    SeamProblem(const TextureSet& set, const SetCover& cover)
        : set_(set), cover_(cover), channels_(static_cast<std::size_t>(set.exemplar.channels)),
          sources_(cover.pixels()), shown_(cover.pixels()), is_odd_(cover.pixels()), first_(cover.pixels() + 1),
          right_(cover.pixels() * channels_), changes_(right_.size())
    {
        find_sources();
        for_pairs([&](std::size_t p, std::size_t q, int, int) { ++first_[p + 1], ++first_[q + 1]; });
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        neighbours_.resize(first_.back());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for_pairs([&](std::size_t p, std::size_t q, int dx, int dy) {
            neighbours_[next[p]++] = static_cast<std::uint32_t>(q);
            neighbours_[next[q]++] = static_cast<std::uint32_t>(p);
            add_step(p, q, dx, dy);
        });
    }

    /// Successive over-relaxation, odd places after even ones. Pixels of an even tile size keep their parity in all
    /// tiles that share them.
    void solve(double length)
    {
        const double screen = 1 / (length * length), shrink = 1 / (1 + screen / 4),
                     relaxation = 2 / (1 + std::sqrt(1 - shrink * shrink));
        // The error shrinks by relaxation - 1, about exp(-1.4 / length), a sweep: by exp(-14) in all.
        const int sweeps = static_cast<int>(10 * length);
        for (int half = 0; half < 2 * sweeps; ++half)
            tbb::parallel_for(std::size_t{0}, sources_.size(), [&](std::size_t p) {
                if (shown_[p] > 0 && is_odd_[p] == half % 2) relax(p, screen, relaxation);
            });
    }

    double change(std::size_t pixel, std::size_t channel) const { return changes_[pixel * channels_ + channel]; }

private:
    /// The source of each pixel, and how many tiles show it.
    void find_sources()
    {
        for (std::size_t tile = 0; tile < set_.tiles.size(); ++tile) {
            const auto sources = set_.sources_of(tile);
            for (int y = 0, i = 0; y < set_.size; ++y)
                for (int x = 0; x < set_.size; ++x, ++i) {
                    const std::size_t p = cover_.pixel(tile, x, y);
                    const SourcePixel source = sources[static_cast<std::size_t>(i)];
                    if (shown_[p]++ > 0 && !(sources_[p] == source))
                        throw InputError("tiles show different sources at a pixel that they share");
                    sources_[p] = source;
                    is_odd_[p] = static_cast<std::uint8_t>((x + y) % 2);
                }
        }
    }

    /// Visits all pairs of neighbours of all tiles, with those across their eastern and southern borders.
    template <class Visit>
    void for_pairs(const Visit& visit) const
    {
        for (std::size_t tile = 0; tile < set_.tiles.size(); ++tile)
            for (int y = 0; y < set_.size; ++y)
                for (int x = 0; x < set_.size; ++x)
                    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
                        const std::size_t q = cover_.pixel(tile, x + dx, y + dy);
                        if (shown_[q] > 0) visit(cover_.pixel(tile, x, y), q, dx, dy);
                    }
    }

    int value(int x, int y, std::size_t channel) const
    {
        const PngPixels& exemplar = set_.exemplar;
        return exemplar.values[exemplar.at(std::clamp(x, 0, exemplar.width - 1), std::clamp(y, 0, exemplar.height - 1),
                                           static_cast<int>(channel))];
    }

    /// Adds the step that a pair should lose: the mean difference of the windows of p and q over both pixels.
    void add_step(std::size_t p, std::size_t q, int dx, int dy)
    {
        const SourcePixel a = sources_[p], b = sources_[q];
        if (b.x - a.x == dx && b.y - a.y == dy) return;
        for (std::size_t c = 0; c < channels_; ++c) {
            const double step = (value(a.x, a.y, c) + value(a.x + dx, a.y + dy, c) - value(b.x, b.y, c) -
                                 value(b.x - dx, b.y - dy, c)) /
                                2.0;
            right_[p * channels_ + c] -= step;
            right_[q * channels_ + c] += step;
        }
    }

    void relax(std::size_t p, double screen, double relaxation)
    {
        const double weight = static_cast<double>(first_[p + 1] - first_[p]) + screen * shown_[p];
        for (std::size_t c = 0; c < channels_; ++c) {
            double sum = right_[p * channels_ + c];
            for (std::size_t i = first_[p]; i < first_[p + 1]; ++i) sum += changes_[neighbours_[i] * channels_ + c];
            double& its = changes_[p * channels_ + c];
            its += relaxation * (sum / weight - its);
        }
    }

    const TextureSet& set_;
    const SetCover& cover_;
    std::size_t channels_;
    std::vector<SourcePixel> sources_;
    std::vector<std::uint32_t> shown_;
    std::vector<std::uint8_t> is_odd_;
    std::vector<std::size_t> first_; ///< the neighbours of each pixel, once for each tile that has the pair
    std::vector<std::uint32_t> neighbours_;
    std::vector<double> right_, changes_;
};

}

double smooth_length(const PngPixels& exemplar)
{
    const auto squares_of_steps = [](const std::uint8_t* values, std::size_t count, std::size_t distance) {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const int step = values[i + distance] - values[i];
            sum += step * step;
        }
        return sum;
    };
    const std::size_t row = exemplar.at(0, 1, 0), channels = static_cast<std::size_t>(exemplar.channels);
    std::int64_t steps = 0;
    for (int y = 0; y < exemplar.height; ++y) {
        const std::uint8_t* const values = &exemplar.values[exemplar.at(0, y, 0)];
        steps += squares_of_steps(values, row - channels, channels);
        if (y + 1 < exemplar.height) steps += squares_of_steps(values, row, row);
    }
    const double width = exemplar.width, height = exemplar.height,
                 pairs = exemplar.channels * ((width - 1) * height + width * (height - 1));
    const double variance = variance_of_channels(exemplar) / exemplar.channels;
    return steps > 0 ? std::sqrt(variance * pairs / static_cast<double>(steps)) : 0;
}

bool is_smooth(const PngPixels& exemplar) { return smooth_length(exemplar) >= 4; }

double fading_length(const PngPixels& exemplar, int size)
{
    return std::clamp(2 * smooth_length(exemplar), 2.0, size / 2.0);
}

bool can_blend(const TextureRequest& request)
{
    const auto side = static_cast<std::size_t>(request.size);
    return request.split == 0 && !request.smooth && request.ring_pixels() > 0 &&
           (request.has_corners() || request.joint) &&
           requested_tiles(request).size() * side * side <= most_blended_pixels;
}

std::string blended_sets()
{
    return fmt::format("is for corner and omega tiles with a ring, and Wang tiles that are chosen together, without "
                       "marked corners and smooth, of at most {} pixels",
                       most_blended_pixels);
}

std::vector<double> seam_changes(const TextureSet& set)
{
    TextureRequest request;
    request.kind = set.kind;
    request.colors = set.colors;
    const SetCover cover(set_parts(request, set.tiles), set.size, set.ring);
    SeamProblem problem(set, cover);
    problem.solve(fading_length(set.exemplar, set.size));
    std::vector<double> changes;
    changes.reserve(set.values.size());
    for (std::size_t tile = 0; tile < set.tiles.size(); ++tile)
        for (int y = 0; y < set.size; ++y)
            for (int x = 0; x < set.size; ++x)
                for (int c = 0; c < set.exemplar.channels; ++c)
                    changes.push_back(problem.change(cover.pixel(tile, x, y), static_cast<std::size_t>(c)));
    return changes;
}

namespace {

/// Shows sources, blended and levelled as the set says.
void show_changes(TextureSet& set)
{
    const auto channels = static_cast<std::size_t>(set.exemplar.channels);
    std::vector<double> shown;
    shown.reserve(set.values.size());
    for (const SourcePixel& source : set.sources)
        for (std::size_t c = 0; c < channels; ++c)
            shown.push_back(set.exemplar.values[set.exemplar.at(source.x, source.y, static_cast<int>(c))]);
    const auto add = [&](const std::vector<double>& changes) {
        for (std::size_t i = 0; i < shown.size(); ++i) shown[i] += changes[i];
    };
    if (set.is_blended) add(seam_changes(set));
    if (set.is_levelled) add(level_changes(set, shown));
    for (std::size_t i = 0; i < shown.size(); ++i)
        set.values[i] = static_cast<std::uint8_t>(std::clamp(std::floor(shown[i] + 0.5), 0.0, 255.0));
}

}

void blend_seams(TextureSet& set)
{
    set.is_blended = true;
    show_changes(set);
}

void level_tiles(TextureSet& set)
{
    set.is_levelled = true;
    show_changes(set);
}

void certify_changes(const TextureSet& set)
{
    if (set.ring < 1) throw InputError("ring = 0: blended and levelled sets have a ring");
    if (set.is_levelled && std::min(set.exemplar.width, set.exemplar.height) < set.size)
        throw InputError(
            fmt::format("the exemplar has {} x {} pixels: levelled sets have an exemplar at least as large "
                        "as a tile, {} x {}",
                        set.exemplar.width, set.exemplar.height, set.size, set.size));
    TextureSet again = set;
    show_changes(again);
    const auto [first, other] = std::ranges::mismatch(set.values, again.values);
    if (first == set.values.end()) return;
    const auto pixel =
        static_cast<std::size_t>(first - set.values.begin()) / static_cast<std::size_t>(set.exemplar.channels);
    const std::size_t place = pixel % set.pixels_a_tile(), side = static_cast<std::size_t>(set.size);
    throw InputError(fmt::format("tile {}: the pixel in column {}, row {} is not its source's, {}",
                                 set.tiles[pixel / set.pixels_a_tile()].index, place % side, place / side,
                                 !set.is_levelled  ? "blended"
                                 : !set.is_blended ? "levelled"
                                                   : "blended and levelled"));
}

}
