#include "host/texture/wang_texture.hpp"

#include "host/texture/wang_samples.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace poissonlab {
namespace {

/// A quarter of a tile, seen from its corner: x and y are distances from the nearest vertical and horizontal edge. The
/// samples of these two edges meet there.
struct Quarter
{
    bool is_north = true;
    bool is_west = true;
};
constexpr std::array<Quarter, 4> quarters{{{true, true}, {true, false}, {false, true}, {false, false}}};

/// The pixel of a sample that a pixel of a quarter would show: samples are centred on the middle of their edge.
SourcePixel source_in_quarter(const SourceCanvas& sample, bool is_horizontal_edge, Quarter quarter, int x, int y)
{
    const int size = sample.size, half = size / 2;
    const int tile_x = quarter.is_west ? x : size - 1 - x, tile_y = quarter.is_north ? y : size - 1 - y;
    return is_horizontal_edge ? sample.at(tile_x, tile_y + (quarter.is_north ? half : -half))
                              : sample.at(tile_x + (quarter.is_west ? half : -half), tile_y);
}

PngPixels quarter_pixels(const PngPixels& exemplar, const SourceCanvas& sample, bool is_horizontal_edge,
                         Quarter quarter)
{
    SourceCanvas canvas{sample.size / 2, {}};
    for (int y = 0; y < canvas.size; ++y)
        for (int x = 0; x < canvas.size; ++x)
            canvas.sources.push_back(source_in_quarter(sample, is_horizontal_edge, quarter, x, y));
    return canvas_pixels(exemplar, canvas);
}

/// Free pixels near the diagonal, but for the ring and the lines through the middle of the tile; "taken" is the sample
/// of the vertical edge.
std::vector<PixelRole> quarter_roles(const TextureRequest& request)
{
    const int half = request.size / 2, band = request.band();
    std::vector<PixelRole> roles;
    for (int y = 0; y < half; ++y)
        for (int x = 0; x < half; ++x) {
            const bool is_fixed = std::min(x, y) < request.ring_pixels() || std::max(x, y) == half - 1 ||
                                  std::abs(x - y) > band || x == y;
            roles.push_back(!is_fixed || (x == y && !(std::min(x, y) < request.ring_pixels() || x == half - 1))
                                ? PixelRole::free
                            : x < y ? PixelRole::taken
                                    : PixelRole::kept);
        }
    return roles;
}

SeamCut quarter_path(const PngPixels& horizontal, const PngPixels& vertical, const TextureRequest& request)
{
    const int half = request.size / 2, ring = request.ring_pixels();
    const auto error = [&](int row, int offset) -> std::int64_t {
        const int column = row + offset;
        if (column < std::min(row, ring) || column >= half) return -1;
        return squared_difference(horizontal, vertical, column, row);
    };
    const DiagonalPath path = minimum_error_path(half, request.band(), ring, error);
    SeamCut cut;
    cut.cost = path.error;
    for (int y = 0; y < half; ++y)
        for (int x = 0; x < half; ++x) cut.taken.push_back(x < y + path.offsets[static_cast<std::size_t>(y)]);
    return cut;
}

/// True if the edges agree on the mark of the corner of a quarter; without marks they always do.
bool meet_in(const TextureRequest& request, std::size_t horizontal, std::size_t vertical, Quarter quarter)
{
    if (request.classes() == 1) return true;
    // Western and southern ends come first in a colour.
    const std::size_t of_horizontal = quarter.is_west ? horizontal / 2 % 2 : horizontal % 2;
    const std::size_t of_vertical = quarter.is_north ? vertical % 2 : vertical / 2 % 2;
    return of_horizontal == of_vertical;
}

class WangTexture
{
public:
    WangTexture(const PngPixels& exemplar, const TextureRequest& request, const std::vector<TextureTile>& tiles,
                const PieceProgress& progress)
        : exemplar_(exemplar), request_(request), tiles_(tiles), progress_(progress), roles_(quarter_roles(request)),
          choice_(exemplar, request)
    {}

    TextureSources make()
    {
        SampleWindows windows = best_random_windows();
        improve(windows);
        return finished(windows);
    }

private:
    SampleWindows best_random_windows() const
    {
        const auto attempts = static_cast<std::size_t>(request_.attempts);
        std::vector<std::int64_t> errors(attempts);
        std::size_t done = 0;
        constexpr std::size_t at_once = 16;
        for (std::size_t first = 0; first < attempts; first += at_once) {
            const std::size_t end = std::min(first + at_once, attempts);
            tbb::parallel_for(
                first, end, [&](std::size_t i) { errors[i] = error_of(choice_.draw(static_cast<std::uint32_t>(i))); });
            done = end;
            progress_("sets of samples", done, attempts);
        }
        return choice_.draw(static_cast<std::uint32_t>(std::ranges::min_element(errors) - errors.begin()));
    }

    /// Coordinate descent: each sample in turn is replaced by the best of some others, all else being fixed.
    void improve(SampleWindows& windows) const
    {
        constexpr std::uint32_t tries = 16;
        for (std::size_t which = 0; which < windows.size(); ++which) {
            std::vector<SampleWindows> choices{windows};
            for (std::uint32_t i = 0; i < tries; ++i) choices.push_back(choice_.replaced(windows, which, i));
            std::vector<std::int64_t> errors(choices.size());
            tbb::parallel_for(std::size_t{0}, choices.size(), [&](std::size_t i) { errors[i] = error_of(choices[i]); });
            windows = choices[static_cast<std::size_t>(std::ranges::min_element(errors) - errors.begin())];
            progress_("better samples", which + 1, windows.size());
        }
    }

    SeamCut cut_of(const SourceCanvas& horizontal, const SourceCanvas& vertical, Quarter quarter) const
    {
        const PngPixels kept = quarter_pixels(exemplar_, horizontal, true, quarter);
        const PngPixels taken = quarter_pixels(exemplar_, vertical, false, quarter);
        return request_.cut == QuiltingCut::path ? quarter_path(kept, taken, request_)
                                                 : minimum_cut(kept, taken, roles_, request_.weight);
    }

    /// The cuts of all quarters of a complete set; a colour pair's quarter is the same in all tiles that have it.
    std::int64_t error_of(const SampleWindows& windows) const
    {
        const EdgeSamples samples = edge_samples(exemplar_, request_, windows);
        std::int64_t error = samples.cost;
        for (std::size_t h = 0; h < samples.horizontal.size(); ++h)
            for (std::size_t v = 0; v < samples.vertical.size(); ++v)
                for (const Quarter quarter : quarters)
                    if (meet_in(request_, h, v, quarter))
                        error += cut_of(samples.horizontal[h], samples.vertical[v], quarter).cost;
        return error;
    }

    TextureSources finished(const SampleWindows& windows) const
    {
        const EdgeSamples samples = edge_samples(exemplar_, request_, windows);
        // Cuts are sorted by horizontal colour, vertical colour and quarter.
        const std::size_t verticals = samples.vertical.size();
        std::vector<SeamCut> cuts(samples.horizontal.size() * verticals * 4);
        tbb::parallel_for(std::size_t{0}, cuts.size(), [&](std::size_t i) {
            const std::size_t h = i / 4 / verticals, v = i / 4 % verticals;
            if (meet_in(request_, h, v, quarters[i % 4]))
                cuts[i] = cut_of(samples.horizontal[h], samples.vertical[v], quarters[i % 4]);
        });
        TextureSources result{{}, samples.cost, windows, windows.size()};
        for (const SeamCut& cut : cuts) result.cost += cut.cost;
        for (const TextureTile& tile : tiles_)
            append_tile(result, samples, cuts, wang_tile(tile.index, request_.set_colors()));
        return result;
    }

    void append_tile(TextureSources& result, const EdgeSamples& samples, const std::vector<SeamCut>& cuts,
                     const WangTile& tile) const
    {
        const int size = request_.size, half = size / 2;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const std::size_t number = (row < half ? 0u : 2u) + (column < half ? 0u : 1u);
                const Quarter quarter = quarters[number];
                const Color h = quarter.is_north ? tile.north : tile.south, v = quarter.is_west ? tile.west : tile.east;
                const int x = quarter.is_west ? column : size - 1 - column, y = quarter.is_north ? row : size - 1 - row;
                const SeamCut& cut = cuts[(std::size_t{h} * samples.vertical.size() + v) * 4 + number];
                const bool is_vertical = cut.taken[static_cast<std::size_t>(y * half + x)];
                result.bow_ties.shown.push_back(is_vertical);
                result.bow_ties.vertical.push_back(source_in_quarter(samples.vertical[v], false, quarter, x, y));
                result.bow_ties.horizontal.push_back(source_in_quarter(samples.horizontal[h], true, quarter, x, y));
                result.sources.push_back(is_vertical ? result.bow_ties.vertical.back()
                                                     : result.bow_ties.horizontal.back());
            }
    }

    const PngPixels& exemplar_;
    const TextureRequest& request_;
    const std::vector<TextureTile>& tiles_;
    const PieceProgress& progress_;
    std::vector<PixelRole> roles_;
    SampleChoice choice_;
};

}

std::int64_t squared_difference(const PngPixels& a, const PngPixels& b, int x, int y)
{
    std::int64_t sum = 0;
    for (int c = 0; c < a.channels; ++c) {
        const int difference = a.values[a.at(x, y, c)] - b.values[b.at(x, y, c)];
        sum += difference * difference;
    }
    return sum;
}

DiagonalPath minimum_error_path(int rows, int band, int pinned,
                                const std::function<std::int64_t(int row, int offset)>& error)
{
    constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max() / 2;
    const int width = 2 * band + 1;
    std::vector<std::int64_t> sums(static_cast<std::size_t>(rows * width), never);
    std::vector<int> before(sums.size(), 0);
    const auto at = [&](int row, int offset) { return static_cast<std::size_t>(row * width + offset + band); };
    for (int row = 0; row < rows; ++row) {
        const int reach = row < std::max(pinned, 1) || row + 1 == rows ? 0 : band;
        for (int offset = -reach; offset <= reach; ++offset) {
            const std::int64_t here = error(row, offset);
            if (here < 0) continue;
            std::int64_t best = row == 0 ? 0 : never;
            for (int last = std::max(offset - 1, -band); row > 0 && last <= std::min(offset + 1, band); ++last)
                if (sums[at(row - 1, last)] < best) best = sums[at(row - 1, last)], before[at(row, offset)] = last;
            if (best < never) sums[at(row, offset)] = best + here;
        }
    }
    DiagonalPath path{std::vector<int>(static_cast<std::size_t>(rows), 0), sums[at(rows - 1, 0)]};
    for (int row = rows - 1; row > 0; --row)
        path.offsets[static_cast<std::size_t>(row - 1)] = before[at(row, path.offsets[static_cast<std::size_t>(row)])];
    return path;
}

TextureSources make_wang_texture(const PngPixels& exemplar, const TextureRequest& request,
                                 const std::vector<TextureTile>& tiles, const PieceProgress& progress)
{
    return WangTexture(exemplar, request, tiles, progress).make();
}

}
