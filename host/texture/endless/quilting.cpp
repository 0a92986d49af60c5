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
        : request_(request), exemplar_(exemplar), block_(request.block), overlap_(std::max(2, request.block / 6)),
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

    /// True where a window nearly goes on as a neighbour does.
    bool goes_on(int x, int y, int column, int row) const
    {
        const int near = std::max(1, block_ / 4);
        const auto follows = [&](int columns_before, int rows_before) {
            if (column < columns_before || row < rows_before || column - columns_before >= columns_) return false;
            const ExemplarWindow& other =
                places_[static_cast<std::size_t>((row - rows_before) * columns_ + column - columns_before)];
            return std::abs(other.x + columns_before * step() - x) < near &&
                   std::abs(other.y + rows_before * step() - y) < near;
        };
        return follows(1, 0) || follows(0, 1) || follows(1, 1) || follows(-1, 1);
    }

    ExemplarWindow chosen_window(int column, int row) const
    {
        RandomWords words(stream_key(request_.seed, Purpose::texture_quilting, 0),
                          static_cast<std::uint32_t>(row * columns_ + column));
        if (column == 0 && row == 0) return drawn_window(words);
        const SquareSums sums = squares_.at(key({column > 0, row > 0}))
                                    ->sums(window_pixels(picture_, {column * step(), row * step(), block_}));
        std::vector<ExemplarWindow> windows;
        for (const bool may_go_on : {false, true}) {
            windows = best_windows(sums, column, row, may_go_on);
            if (!windows.empty()) break;
        }
        return windows[words.below(static_cast<std::uint32_t>(windows.size()))];
    }

    /// Those whose difference is at most a tolerance above the smallest one.
    std::vector<ExemplarWindow> best_windows(const SquareSums& sums, int column, int row, bool may_go_on) const
    {
        const auto is_allowed = [&](int x, int y) { return may_go_on || !goes_on(x, y, column, row); };
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
    // A block follows those to the west, the north-west, the north and the north-east: column + 2 row counts the steps.
    const int steps = quilt.columns() + 2 * (quilt.rows() - 1);
    for (int step = 0; step < steps; ++step) {
        tell(step, steps);
        const int first = std::max(0, (step - quilt.columns() + 2) / 2), last = std::min(quilt.rows() - 1, step / 2);
        tbb::parallel_for(first, last + 1, [&](int row) { quilt.add_block(step - 2 * row, row); });
    }
    return quilt.cropped(width, height);
}

}
