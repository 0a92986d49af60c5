#include "host/texture/endless/quilting.hpp"

#include "base/random/random_words.hpp"
#include "host/texture/masked_squares.hpp"
#include "host/texture/window_choice.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace poissonlab {
namespace {

/// Columns and rows of blocks within which no window is taken twice.
constexpr int neighbor_reach = 3;

/// The sides on which a block lies over what is there.
struct OverlapSides
{
    bool west = false;
    bool north = false;
};

PieceMask overlap_mask(int block, int overlap, OverlapSides sides)
{
    PieceMask mask{block, block, {}};
    for (int y = 0; y < block; ++y)
        for (int x = 0; x < block; ++x)
            mask.counts.push_back((sides.west && x < overlap) || (sides.north && y < overlap) ? 1 : 0);
    return mask;
}

/// For each row of a strip, its first pixel that shows the new block: the path of least error from top to bottom, of
/// which neighbouring rows differ by at most one column.
std::vector<int> least_path(const std::vector<std::int64_t>& errors, int columns)
{
    const int rows = static_cast<int>(errors.size()) / columns;
    std::vector<std::int64_t> sums = errors;
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * columns + x); };
    const auto best_above = [&](int x, int y) {
        int best = x;
        for (const int other : {x - 1, x + 1})
            if (other >= 0 && other < columns && sums[at(other, y - 1)] < sums[at(best, y - 1)]) best = other;
        return best;
    };
    for (int y = 1; y < rows; ++y)
        for (int x = 0; x < columns; ++x) sums[at(x, y)] += sums[at(best_above(x, y), y - 1)];
    std::vector<int> path(static_cast<std::size_t>(rows));
    const auto last = sums.end() - columns;
    path.back() = static_cast<int>(std::min_element(last, sums.end()) - last);
    for (int y = rows - 1; y > 0; --y)
        path[static_cast<std::size_t>(y - 1)] = best_above(path[static_cast<std::size_t>(y)], y);
    return path;
}

class Quilt
{
public:
    Quilt(const EndlessRequest& request, const PngPixels& exemplar, int width, int height)
        : request_(request), exemplar_(exemplar), block_(request.block), overlap_(block_ - quilting_step(request)),
          columns_(blocks_along(width)), rows_(blocks_along(height)), picture_{columns_ * step() + overlap_,
                                                                               rows_ * step() + overlap_,
                                                                               exemplar.channels,
                                                                               {}},
          places_(static_cast<std::size_t>(columns_ * rows_))
    {
        picture_.values.resize(picture_.at(0, picture_.height, 0));
        sources_.resize(picture_.values.size() / static_cast<std::size_t>(picture_.channels));
        for (const OverlapSides sides : {OverlapSides{true, false}, {false, true}, {true, true}})
            squares_[key(sides)] = std::make_unique<MaskedSquares>(exemplar, overlap_mask(block_, overlap_, sides));
    }

    int columns() const { return columns_; }
    int rows() const { return rows_; }

    /// Blocks of an antidiagonal need those of earlier ones only.
    void add_block(int column, int row)
    {
        const ExemplarWindow window = chosen_window(column, row);
        places_[static_cast<std::size_t>(row * columns_ + column)] = window;
        const std::vector<bool> taken = taken_pixels(window, column, row);
        for (int y = 0; y < block_; ++y)
            for (int x = 0; x < block_; ++x)
                if (taken[static_cast<std::size_t>(y * block_ + x)])
                    copy_pixel(window.x + x, window.y + y, column * step() + x, row * step() + y);
    }

    QuiltedPicture cropped(int width, int height) const
    {
        QuiltedPicture result;
        result.pixels = {width, height, picture_.channels, {}};
        for (int y = 0; y < height; ++y) {
            const auto first = picture_.values.begin() + static_cast<std::ptrdiff_t>(picture_.at(0, y, 0));
            result.pixels.values.insert(result.pixels.values.end(), first,
                                        first + static_cast<std::ptrdiff_t>(width) * picture_.channels);
            const auto source = sources_.begin() + static_cast<std::ptrdiff_t>(y) * picture_.width;
            result.sources.insert(result.sources.end(), source, source + width);
        }
        return result;
    }

private:
    int step() const { return block_ - overlap_; }
    int blocks_along(int pixels) const { return std::max(1, (pixels - overlap_ + step() - 1) / step()); }
    static int key(OverlapSides sides) { return (sides.west ? 1 : 0) + (sides.north ? 2 : 0); }

    ExemplarWindow drawn_window(RandomWords& words) const
    {
        const auto below = [&](int size) { return static_cast<int>(words.below(static_cast<std::uint32_t>(size))); };
        const int x = below(exemplar_.width - block_ + 1);
        return {x, below(exemplar_.height - block_ + 1), block_};
    }

    /// Windows nearer than this along both axes are the same to the eye.
    int near() const
    {
        const double places = static_cast<double>(exemplar_.width - block_ + 1) * (exemplar_.height - block_ + 1);
        const double neighbors = neighbor_reach * (2 * neighbor_reach + 2) + 4; // and continuations
        return std::clamp(static_cast<int>(std::sqrt(places / (4 * neighbors)) / 2), 1, std::max(1, block_ / 4));
    }

    /// True where a window nearly goes on as a neighbour does, or shows what a block not far away shows.
    bool is_forbidden(int x, int y, int column, int row) const
    {
        const int apart = near();
        const auto is_near = [&](const ExemplarWindow& window, int dx, int dy) {
            return std::abs(window.x + dx - x) < apart && std::abs(window.y + dy - y) < apart;
        };
        for (int up = 0; up <= std::min(row, neighbor_reach); ++up)
            for (int west = up == 0 ? 1 : -neighbor_reach; west <= neighbor_reach; ++west) {
                const int other = column - west;
                if (other < 0 || other >= columns_) continue;
                const ExemplarWindow& window = places_[static_cast<std::size_t>((row - up) * columns_ + other)];
                if (is_near(window, 0, 0)) return true;
                if (up <= 1 && std::abs(west) <= 1 && is_near(window, west * step(), up * step())) return true;
            }
        return false;
    }

    ExemplarWindow chosen_window(int column, int row) const
    {
        RandomWords words(stream_key(request_.seed, Purpose::texture_quilting, 0),
                          static_cast<std::uint32_t>(row * columns_ + column));
        if (column == 0 && row == 0) return drawn_window(words);
        const SquareSums sums = squares_.at(key({column > 0, row > 0}))
                                    ->sums(window_pixels(picture_, {column * step(), row * step(), block_}));
        std::vector<ExemplarWindow> windows;
        for (const bool may_repeat : {false, true}) {
            windows = best_windows(sums, column, row, may_repeat);
            if (!windows.empty()) break;
        }
        return windows[words.below(static_cast<std::uint32_t>(windows.size()))];
    }

    /// The windows whose difference is at most a tolerance above the smallest one.
    std::vector<ExemplarWindow> best_windows(const SquareSums& sums, int column, int row, bool may_repeat) const
    {
        const auto is_allowed = [&](int x, int y) { return may_repeat || !is_forbidden(x, y, column, row); };
        std::uint64_t least = ~std::uint64_t{0};
        for (int y = 0; y < sums.rows; ++y)
            for (int x = 0; x < sums.columns; ++x)
                if (sums.at(x, y) < least && is_allowed(x, y)) least = sums.at(x, y);
        const auto most = static_cast<std::uint64_t>(static_cast<double>(least) * (1 + request_.tolerance));
        std::vector<ExemplarWindow> windows;
        for (int y = 0; y < sums.rows; ++y)
            for (int x = 0; x < sums.columns; ++x)
                if (sums.at(x, y) <= most && is_allowed(x, y)) windows.push_back({x, y, block_});
        return windows;
    }

    std::int64_t error(const ExemplarWindow& window, int column, int row, int x, int y) const
    {
        std::int64_t sum = 0;
        for (int c = 0; c < picture_.channels; ++c) {
            const int difference = picture_.values[picture_.at(column * step() + x, row * step() + y, c)] -
                                   exemplar_.values[exemplar_.at(window.x + x, window.y + y, c)];
            sum += difference * difference;
        }
        return sum;
    }

    /// The pixels that show a block: those beyond both paths.
    std::vector<bool> taken_pixels(const ExemplarWindow& window, int column, int row) const
    {
        std::vector<int> west(static_cast<std::size_t>(block_), 0), north = west;
        const auto strip = [&](bool is_west) {
            std::vector<std::int64_t> errors;
            for (int along = 0; along < block_; ++along)
                for (int across = 0; across < overlap_; ++across)
                    errors.push_back(is_west ? error(window, column, row, across, along)
                                             : error(window, column, row, along, across));
            return errors;
        };
        if (column > 0) west = least_path(strip(true), overlap_);
        if (row > 0) north = least_path(strip(false), overlap_);
        std::vector<bool> taken;
        for (int y = 0; y < block_; ++y)
            for (int x = 0; x < block_; ++x)
                taken.push_back(x >= west[static_cast<std::size_t>(y)] && y >= north[static_cast<std::size_t>(x)]);
        return taken;
    }

    void copy_pixel(int from_x, int from_y, int x, int y)
    {
        for (int c = 0; c < picture_.channels; ++c)
            picture_.values[picture_.at(x, y, c)] = exemplar_.values[exemplar_.at(from_x, from_y, c)];
        sources_[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) + static_cast<std::size_t>(x)] =
            {static_cast<std::uint16_t>(from_x), static_cast<std::uint16_t>(from_y)};
    }

    const EndlessRequest& request_;
    const PngPixels& exemplar_;
    int block_, overlap_, columns_, rows_;
    PngPixels picture_; ///< of whole blocks
    std::vector<SourcePixel> sources_;
    std::vector<ExemplarWindow> places_; ///< of blocks, row by row
    std::map<int, std::unique_ptr<MaskedSquares>> squares_;
};

}

QuiltedPicture quilted_picture(const EndlessRequest& request, const PngPixels& exemplar, int width, int height,
                               const std::function<void(int done, int total)>& tell)
{
    check(request, exemplar);
    Quilt quilt(request, exemplar, width, height);
    // A block follows those to the west, and those of rows before it up to three columns to the east: column + slope
    // row counts the steps.
    constexpr int slope = neighbor_reach + 1;
    const int steps = quilt.columns() + slope * (quilt.rows() - 1);
    for (int step = 0; step < steps; ++step) {
        tell(step, steps);
        const int first = std::max(0, (step - quilt.columns() + slope) / slope);
        const int last = std::min(quilt.rows() - 1, step / slope);
        tbb::parallel_for(first, last + 1, [&](int row) { quilt.add_block(step - slope * row, row); });
    }
    return quilt.cropped(width, height);
}

}
