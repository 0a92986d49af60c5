#include "host/texture/wang_samples.hpp"

#include "base/random/random.hpp"
#include "host/texture/wang_texture.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

SourceCanvas canvas_of(const ExemplarWindow& window)
{
    SourceCanvas canvas{window.size, {}};
    for (int y = 0; y < window.size; ++y)
        for (int x = 0; x < window.size; ++x)
            canvas.sources.push_back(
                {static_cast<std::uint16_t>(window.x + x), static_cast<std::uint16_t>(window.y + y)});
    return canvas;
}

/// Half of the width of the band in which two samples of an edge overlap: the ends of the edge stay those of their
/// marks.
int joint_band(const TextureRequest& request) { return std::min(request.band(), request.size / 4); }

/// Free pixels around the line across the middle of an edge; "taken" is the eastern or northern sample.
std::vector<PixelRole> joint_roles(const TextureRequest& request, bool is_vertical)
{
    const int size = request.size, half = size / 2, band = joint_band(request);
    std::vector<PixelRole> roles;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const int along = is_vertical ? size - 1 - y : x; // from the western or southern end
            roles.push_back(along < half - band    ? PixelRole::kept
                            : along >= half + band ? PixelRole::taken
                                                   : PixelRole::free);
        }
    return roles;
}

/// A path across the edge instead: row k is at distance k from one side of the sample.
SeamCut joint_path(const PngPixels& first, const PngPixels& last, const TextureRequest& request, bool is_vertical)
{
    const int size = request.size, half = size / 2;
    const auto place = [&](int row, int along) { // of a pixel, by its distance from the first end
        return is_vertical ? std::pair(row, size - 1 - along) : std::pair(along, row);
    };
    const auto error = [&](int row, int offset) -> std::int64_t {
        const auto [x, y] = place(row, half + offset);
        return squared_difference(first, last, x, y);
    };
    const DiagonalPath path = minimum_error_path(size, joint_band(request) - 1, 0, error);
    SeamCut cut;
    cut.cost = path.error;
    cut.taken.resize(static_cast<std::size_t>(size * size));
    for (int row = 0; row < size; ++row)
        for (int along = 0; along < size; ++along) {
            const auto [x, y] = place(row, along);
            cut.taken[static_cast<std::size_t>(y * size + x)] =
                along >= half + path.offsets[static_cast<std::size_t>(row)];
        }
    return cut;
}

/// The sample of an edge between corners of different exemplars.
SourceCanvas joined(const PngPixels& exemplar, const TextureRequest& request, const ExemplarWindow& first,
                    const ExemplarWindow& last, bool is_vertical, std::int64_t& cost)
{
    const PngPixels kept = window_pixels(exemplar, first), taken = window_pixels(exemplar, last);
    const SeamCut cut = request.cut == QuiltingCut::path
                            ? joint_path(kept, taken, request, is_vertical)
                            : minimum_cut(kept, taken, joint_roles(request, is_vertical), request.weight);
    SourceCanvas canvas = canvas_of(first);
    put_piece(canvas, {last, cut});
    cost += cut.cost;
    return canvas;
}

}

SampleChoice::SampleChoice(const PngPixels& exemplar, const TextureRequest& request)
    : exemplar_(exemplar), request_(request), count_(std::size_t{request.colors.horizontal + request.colors.vertical} *
                                                     static_cast<std::size_t>(request.classes())),
      distance_(window_distance(exemplar, request.size, count_, request.diversity, request.split))
{}

ExemplarWindow SampleChoice::free_window(const UsedWindows& used, std::size_t number, RandomWords& words) const
{
    const bool is_marked = request_.classes() == 2 && number % 2 == 1;
    return used.draw(exemplar_, columns_of(exemplar_, request_.split, is_marked), request_.size, words);
}

SampleWindows SampleChoice::draw(std::uint32_t attempt) const
{
    RandomWords words(stream_key(request_.seed, Purpose::texture_windows, 1, attempt), 0);
    UsedWindows used(distance_);
    for (std::size_t number = 0; number < count_; ++number) used.add(free_window(used, number, words));
    return used.windows();
}

SampleWindows SampleChoice::replaced(const SampleWindows& windows, std::size_t which, std::uint32_t attempt) const
{
    RandomWords words(stream_key(request_.seed, Purpose::texture_windows, 2, attempt),
                      static_cast<std::uint32_t>(which));
    UsedWindows used(distance_);
    for (std::size_t other = 0; other < windows.size(); ++other)
        if (other != which) used.add(windows[other]);
    SampleWindows changed = windows;
    changed[which] = free_window(used, which, words);
    return changed;
}

EdgeSamples edge_samples(const PngPixels& exemplar, const TextureRequest& request, const SampleWindows& windows)
{
    EdgeSamples samples;
    const auto classes = static_cast<std::size_t>(request.classes());
    for (std::size_t color = 0; color < windows.size() / classes; ++color) {
        const bool is_vertical = color >= request.colors.horizontal;
        std::vector<SourceCanvas>& shown = is_vertical ? samples.vertical : samples.horizontal;
        for (std::size_t first = 0; first < classes; ++first)
            for (std::size_t last = 0; last < classes; ++last) {
                const ExemplarWindow &at_first = windows[color * classes + first],
                                     &at_last = windows[color * classes + last];
                shown.push_back(first == last
                                    ? canvas_of(at_first)
                                    : joined(exemplar, request, at_first, at_last, is_vertical, samples.cost));
            }
    }
    return samples;
}

}
