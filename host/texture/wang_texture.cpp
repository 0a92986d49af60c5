#include "host/texture/wang_texture.hpp"

#include "base/random/random.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <numeric>

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
SourcePixel source_in_quarter(const ExemplarWindow& sample, bool is_horizontal_edge, Quarter quarter, int x, int y)
{
    const int size = sample.size, half = size / 2;
    const int tile_x = quarter.is_west ? x : size - 1 - x, tile_y = quarter.is_north ? y : size - 1 - y;
    const int shown_x = is_horizontal_edge ? tile_x : tile_x + (quarter.is_west ? half : -half);
    const int shown_y = is_horizontal_edge ? tile_y + (quarter.is_north ? half : -half) : tile_y;
    return {static_cast<std::uint16_t>(sample.x + shown_x), static_cast<std::uint16_t>(sample.y + shown_y)};
}

PngPixels quarter_pixels(const PngPixels& exemplar, const ExemplarWindow& sample, bool is_horizontal_edge,
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
        std::int64_t sum = 0;
        for (int c = 0; c < horizontal.channels; ++c) {
            const int difference =
                horizontal.values[horizontal.at(column, row, c)] - vertical.values[vertical.at(column, row, c)];
            sum += difference * difference;
        }
        return sum;
    };
    const DiagonalPath path = minimum_error_path(half, request.band(), ring, error);
    SeamCut cut;
    cut.cost = path.error;
    for (int y = 0; y < half; ++y)
        for (int x = 0; x < half; ++x) cut.taken.push_back(x < y + path.offsets[static_cast<std::size_t>(y)]);
    return cut;
}

/// Samples of all colours: those of horizontal edges, then those of vertical ones.
using Samples = std::vector<ExemplarWindow>;

class WangTexture
{
public:
    WangTexture(const PngPixels& exemplar, const TextureRequest& request, const std::vector<TextureTile>& tiles,
                const PieceProgress& progress)
        : exemplar_(exemplar), request_(request), tiles_(tiles), progress_(progress), roles_(quarter_roles(request)),
          horizontal_(request.colors.horizontal),
          distance_(window_distance(exemplar, request.size, horizontal_ + request.colors.vertical, request.diversity))
    {}

    TextureSources make()
    {
        Samples samples = best_random_samples();
        improve(samples);
        return finished(samples);
    }

private:
    Samples random_samples(std::uint32_t attempt) const
    {
        RandomWords words(stream_key(request_.seed, Purpose::texture_windows, 1, attempt), 0);
        UsedWindows used(distance_);
        for (Color color = 0; color < horizontal_ + request_.colors.vertical; ++color)
            used.add(used.draw(exemplar_, request_.size, words));
        return used.windows();
    }

    Samples best_random_samples() const
    {
        const auto attempts = static_cast<std::size_t>(request_.attempts);
        std::vector<std::int64_t> errors(attempts);
        std::size_t done = 0;
        constexpr std::size_t at_once = 16;
        for (std::size_t first = 0; first < attempts; first += at_once) {
            const std::size_t end = std::min(first + at_once, attempts);
            tbb::parallel_for(first, end, [&](std::size_t i) {
                errors[i] = error_of(random_samples(static_cast<std::uint32_t>(i)));
            });
            done = end;
            progress_("sets of samples", done, attempts);
        }
        return random_samples(static_cast<std::uint32_t>(std::ranges::min_element(errors) - errors.begin()));
    }

    /// Coordinate descent: each sample in turn is replaced by the best of some others, all else being fixed.
    void improve(Samples& samples) const
    {
        constexpr std::uint32_t tries = 16;
        for (std::size_t which = 0; which < samples.size(); ++which) {
            std::vector<Samples> choices(tries + 1, samples);
            for (std::uint32_t i = 0; i < tries; ++i) {
                RandomWords words(stream_key(request_.seed, Purpose::texture_windows, 2, i),
                                  static_cast<std::uint32_t>(which));
                UsedWindows used(distance_);
                for (std::size_t other = 0; other < samples.size(); ++other)
                    if (other != which) used.add(samples[other]);
                choices[i + 1][which] = used.draw(exemplar_, request_.size, words);
            }
            std::vector<std::int64_t> errors(choices.size());
            tbb::parallel_for(std::size_t{0}, choices.size(), [&](std::size_t i) { errors[i] = error_of(choices[i]); });
            samples = choices[static_cast<std::size_t>(std::ranges::min_element(errors) - errors.begin())];
            progress_("better samples", which + 1, samples.size());
        }
    }

    SeamCut cut_of(const ExemplarWindow& horizontal, const ExemplarWindow& vertical, Quarter quarter) const
    {
        const PngPixels kept = quarter_pixels(exemplar_, horizontal, true, quarter);
        const PngPixels taken = quarter_pixels(exemplar_, vertical, false, quarter);
        return request_.cut == QuiltingCut::path ? quarter_path(kept, taken, request_)
                                                 : minimum_cut(kept, taken, roles_, request_.weight);
    }

    /// The cuts of all quarters of a complete set; a colour pair's quarter is the same in all tiles that have it.
    std::int64_t error_of(const Samples& samples) const
    {
        std::int64_t error = 0;
        for (std::size_t h = 0; h < horizontal_; ++h)
            for (std::size_t v = horizontal_; v < samples.size(); ++v)
                for (const Quarter quarter : quarters) error += cut_of(samples[h], samples[v], quarter).cost;
        return error;
    }

    TextureSources finished(const Samples& samples) const
    {
        // By horizontal colour, vertical colour, quarter.
        std::vector<SeamCut> cuts(horizontal_ * request_.colors.vertical * 4);
        tbb::parallel_for(std::size_t{0}, cuts.size(), [&](std::size_t i) {
            cuts[i] = cut_of(samples[i / 4 / request_.colors.vertical],
                             samples[horizontal_ + i / 4 % request_.colors.vertical], quarters[i % 4]);
        });
        TextureSources result{{}, 0, samples, {}, {}};
        for (const SeamCut& cut : cuts) result.cost += cut.cost;
        for (const TextureTile& tile : tiles_)
            append_tile(result, samples, cuts, wang_tile(tile.index, request_.colors));
        return result;
    }

    void append_tile(TextureSources& result, const Samples& samples, const std::vector<SeamCut>& cuts,
                     const WangTile& tile) const
    {
        const int size = request_.size, half = size / 2;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const std::size_t number = (row < half ? 0u : 2u) + (column < half ? 0u : 1u);
                const Quarter quarter = quarters[number];
                const Color h = quarter.is_north ? tile.north : tile.south, v = quarter.is_west ? tile.west : tile.east;
                const int x = quarter.is_west ? column : size - 1 - column, y = quarter.is_north ? row : size - 1 - row;
                const SeamCut& cut = cuts[(std::size_t{h} * request_.colors.vertical + v) * 4 + number];
                const bool is_vertical = cut.taken[static_cast<std::size_t>(y * half + x)];
                result.bow_ties.shown.push_back(is_vertical);
                result.bow_ties.vertical.push_back(source_in_quarter(samples[horizontal_ + v], false, quarter, x, y));
                result.bow_ties.horizontal.push_back(source_in_quarter(samples[h], true, quarter, x, y));
                result.sources.push_back(is_vertical ? result.bow_ties.vertical.back()
                                                     : result.bow_ties.horizontal.back());
            }
    }

    const PngPixels& exemplar_;
    const TextureRequest& request_;
    const std::vector<TextureTile>& tiles_;
    const PieceProgress& progress_;
    std::vector<PixelRole> roles_;
    std::size_t horizontal_; ///< how many colours horizontal edges have
    int distance_;
};

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
