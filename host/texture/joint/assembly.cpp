#include "host/texture/joint/assembly.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poissonlab {
namespace {

/// A picture with a border of one pixel, which has the colours beside it.
PngPixels with_rim(const PngPixels& picture)
{
    PngPixels rimmed{picture.width + 2, picture.height + 2, picture.channels, {}};
    for (int y = -1; y <= picture.height; ++y)
        for (int x = -1; x <= picture.width; ++x)
            for (int c = 0; c < picture.channels; ++c)
                rimmed.values.push_back(picture.values[picture.at(std::clamp(x, 0, picture.width - 1),
                                                                  std::clamp(y, 0, picture.height - 1), c)]);
    return rimmed;
}

std::vector<std::uint8_t> rounded_means(const PngPixels& exemplar, const std::vector<RegularWave>& waves)
{
    const PhaseMeans means(exemplar, waves);
    std::vector<std::uint8_t> rounded(exemplar.values.size());
    tbb::parallel_for(0, exemplar.height, [&](int y) {
        for (int x = 0; x < exemplar.width; ++x)
            for (int c = 0; c < exemplar.channels; ++c)
                rounded[exemplar.at(x, y, c)] = static_cast<std::uint8_t>(std::lround(means.at(x, y, c)));
    });
    return rounded;
}

}

Assembly::Assembly(const PngPixels& exemplar, const SetCover& cover, const Weights& weights,
                   const std::vector<RegularWave>& waves)
    : exemplar_(exemplar), cover_(cover), rimmed_(with_rim(exemplar)), means_(rounded_means(exemplar, waves)),
      sources_(cover.pixels())
{
    weigh_directions();
    double variance = 0; // sum over channels, from the rounded means
    const auto channels = static_cast<std::size_t>(exemplar.channels);
    for (std::size_t c = 0; c < channels; ++c) {
        std::int64_t squares = 0;
        for (std::size_t i = c; i < exemplar.values.size(); i += channels)
            squares += (exemplar.values[i] - means_[i]) * (exemplar.values[i] - means_[i]);
        variance += static_cast<double>(squares) / static_cast<double>(exemplar.values.size() / channels);
    }
    const double spread = std::sqrt(variance / exemplar.channels);
    const auto tiles = static_cast<double>(cover.parts().tiles.size());
    natural_squares_ = tiles * cover.size() * cover.size() * variance;
    if (spread == 0) return;
    repetition_ = seam_unit * weights.repetition / (tiles * spread);
    contrast_ = seam_unit * weights.contrast / (2 * spread * natural_squares_);
    measure_steps(weights.lines);
}

void Assembly::measure_steps(double weight)
{
    if (weight <= 0) return;
    std::array<std::int64_t, 2> sums{};
    for (int y = 0; y < exemplar_.height; ++y)
        for (int x = 0; x < exemplar_.width; ++x) {
            sums[0] += step_unit * distance(x, y, x + 1, y);
            sums[1] += step_unit * distance(x, y, x, y + 1);
        }
    const std::int64_t count = std::int64_t{exemplar_.width} * exemplar_.height;
    mean_steps_ = {static_cast<int>(sums[0] / count), static_cast<int>(sums[1] / count)};
    const double mean = static_cast<double>(sums[0] + sums[1]) / static_cast<double>(2 * count);
    const double pixels = static_cast<double>(cover_.parts().tiles.size()) * cover_.size(); // of a line
    line_ = seam_unit * weight / (step_unit * pixels * mean);
}

void Assembly::add_steps(std::vector<std::int64_t>& lines, SourcePixel source, int x, int y, int tiles) const
{
    if (line_ == 0) return;
    const Steps steps = steps_beyond(source);
    lines[static_cast<std::size_t>(x)] += std::int64_t{tiles} * steps[0];
    lines[static_cast<std::size_t>(cover_.size() + y)] += std::int64_t{tiles} * steps[1];
}

/// The product of both weights is that of equal ones; steps that are missing altogether in one direction count no more
/// than 16 times as much there.
void Assembly::weigh_directions()
{
    std::array<double, 2> steps{};
    for (int y = 0; y + 1 < exemplar_.height; ++y)
        for (int x = 0; x + 1 < exemplar_.width; ++x) {
            steps[0] += distance(x, y, x + 1, y);
            steps[1] += distance(x, y, x, y + 1);
        }
    const double ratio = steps[0] == steps[1] ? 1 : steps[0] / steps[1]; // infinite where steps[1] is 0
    const double east = std::clamp(1 / std::sqrt(ratio), 0.25, 4.0);
    step_weights_ = {static_cast<int>(std::lround(seam_unit * east)), static_cast<int>(std::lround(seam_unit / east))};
}

int Assembly::distance(int ax, int ay, int bx, int by) const
{
    const std::uint8_t* const a = &rimmed_.values[rimmed_.at(ax + 1, ay + 1, 0)];
    const std::uint8_t* const b = &rimmed_.values[rimmed_.at(bx + 1, by + 1, 0)];
    int sum = 0;
    for (int c = 0; c < rimmed_.channels; ++c) sum += std::abs(a[c] - b[c]);
    return sum;
}

std::int64_t Assembly::seam_cost(SourcePixel first, SourcePixel second, Neighbour neighbour) const
{
    const int dx = neighbour == Neighbour::east ? 1 : 0, dy = 1 - dx;
    if (second.x - first.x == dx && second.y - first.y == dy) return 0;
    const int levels = distance(first.x, first.y, second.x - dx, second.y - dy) +
                       distance(first.x + dx, first.y + dy, second.x, second.y);
    return cost_of_levels(levels, neighbour);
}

std::int64_t Assembly::seams() const
{
    std::int64_t sum = 0;
    const int size = cover_.size();
    for (std::size_t tile = 0; tile < cover_.parts().tiles.size(); ++tile)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const SourcePixel here = source(cover_.pixel(tile, x, y));
                sum += seam_cost(here, source(cover_.pixel(tile, x + 1, y)), Neighbour::east) +
                       seam_cost(here, source(cover_.pixel(tile, x, y + 1)), Neighbour::south);
            }
    return sum;
}

void Assembly::count_tiles()
{
    const int size = cover_.size();
    sums_.assign(sum_at(0, size), 0);
    lines_.assign(static_cast<std::size_t>(2 * size), 0);
    squares_ = 0;
    for (std::size_t tile = 0; tile < cover_.parts().tiles.size(); ++tile)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const SourcePixel shown = source(cover_.pixel(tile, x, y));
                add_steps(lines_, shown, x, y, 1);
                for (int c = 0; c < exemplar_.channels; ++c) {
                    const int its = deviation(shown, c);
                    sums_[sum_at(x, y) + static_cast<std::size_t>(c)] += its;
                    squares_ += its * its;
                }
            }
}

double Assembly::contrast_cost(std::int64_t squares) const
{
    const double excess = static_cast<double>(squares) - natural_squares_;
    return contrast_ * excess * excess;
}

double Assembly::sums_gain(const std::vector<ChangedPixel>& pixels) const
{
    std::vector<std::int64_t> changes(sums_.size()), line_changes(lines_.size());
    std::int64_t squares = squares_, repeated = 0;
    for (const ChangedPixel& pixel : pixels) {
        add_steps(line_changes, pixel.source, pixel.tile_x, pixel.tile_y, pixel.tiles);
        add_steps(line_changes, source(pixel.pixel), pixel.tile_x, pixel.tile_y, -pixel.tiles);
        for (int c = 0; c < exemplar_.channels; ++c) {
            const int now = deviation(source(pixel.pixel), c), then = deviation(pixel.source, c);
            changes[sum_at(pixel.tile_x, pixel.tile_y) + static_cast<std::size_t>(c)] += pixel.tiles * (then - now);
            squares += pixel.tiles * (then * then - now * now);
        }
    }
    for (std::size_t i = 0; i < sums_.size(); ++i) repeated -= changes[i] * (2 * sums_[i] + changes[i]);
    double lines = 0;
    for (std::size_t i = 0; i < lines_.size(); ++i)
        lines -= static_cast<double>(line_changes[i]) * static_cast<double>(2 * lines_[i] + line_changes[i]);
    return repetition_ * static_cast<double>(repeated) + line_ * lines + contrast_cost(squares_) -
           contrast_cost(squares);
}

double Assembly::change_cost(const ChangedPixel& pixel, int layers) const
{
    const std::size_t at = sum_at(pixel.tile_x, pixel.tile_y);
    double repeated = 0, squares = 0, lines = 0;
    for (int c = 0; c < exemplar_.channels; ++c) {
        const double now = deviation(source(pixel.pixel), c), then = deviation(pixel.source, c), step = then - now;
        repeated += 2 * static_cast<double>(sums_[at + static_cast<std::size_t>(c)]) * step + layers * step * step;
        squares += then * then - now * now;
    }
    if (line_ > 0) {
        const Steps now = steps_beyond(source(pixel.pixel)), then = steps_beyond(pixel.source);
        lines =
            static_cast<double>(lines_[static_cast<std::size_t>(pixel.tile_x)]) * (then[0] - now[0]) +
            static_cast<double>(lines_[static_cast<std::size_t>(cover_.size() + pixel.tile_y)]) * (then[1] - now[1]);
    }
    const double excess = static_cast<double>(squares_) - natural_squares_;
    return pixel.tiles * (repetition_ * repeated + 2 * line_ * lines + 2 * contrast_ * excess * squares);
}

void Assembly::change(const std::vector<ChangedPixel>& pixels)
{
    for (const ChangedPixel& pixel : pixels) {
        add_steps(lines_, pixel.source, pixel.tile_x, pixel.tile_y, pixel.tiles);
        add_steps(lines_, source(pixel.pixel), pixel.tile_x, pixel.tile_y, -pixel.tiles);
        for (int c = 0; c < exemplar_.channels; ++c) {
            const int now = deviation(source(pixel.pixel), c), then = deviation(pixel.source, c);
            sums_[sum_at(pixel.tile_x, pixel.tile_y) + static_cast<std::size_t>(c)] += pixel.tiles * (then - now);
            squares_ += pixel.tiles * (then * then - now * now);
        }
        sources_[pixel.pixel] = pixel.source;
    }
}

double Assembly::cost() const
{
    double repeated = 0, lines = 0;
    for (const std::int64_t sum : sums_) repeated += static_cast<double>(sum) * static_cast<double>(sum);
    for (const std::int64_t sum : lines_) lines += static_cast<double>(sum) * static_cast<double>(sum);
    return static_cast<double>(seams()) + repetition_ * repeated + line_ * lines + contrast_cost(squares_);
}

namespace {

/// The pixel of a run that is so many to the east of its first one.
ChangedPixel pixel_of(const ChangedRun& run, int step)
{
    ChangedPixel pixel = run.first;
    pixel.pixel += static_cast<std::size_t>(step);
    pixel.source.x = static_cast<std::uint16_t>(pixel.source.x + step);
    pixel.tile_x += step;
    return pixel;
}

}

std::vector<ChangedRun> runs_of(const std::vector<ChangedPixel>& pixels)
{
    std::vector<ChangedRun> runs;
    for (const ChangedPixel& pixel : pixels)
        if (!runs.empty() && pixel == pixel_of(runs.back(), runs.back().length))
            ++runs.back().length;
        else
            runs.push_back({pixel, 1});
    runs.shrink_to_fit();
    return runs;
}

std::vector<ChangedPixel> pixels_of(const std::vector<ChangedRun>& runs)
{
    std::vector<ChangedPixel> pixels;
    for (const ChangedRun& run : runs)
        for (int step = 0; step < run.length; ++step) pixels.push_back(pixel_of(run, step));
    return pixels;
}

}
