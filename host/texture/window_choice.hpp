// Which windows of an exemplar a texture set takes: all of them some distance apart, so that tiles show different
// things.
#pragma once

#include "base/images/png_file.hpp"
#include "base/random/random_words.hpp"
#include "host/texture/masked_squares.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace poissonlab {

/// A square of pixels of the exemplar by its upper left corner.
struct ExemplarWindow
{
    int x = 0;
    int y = 0;
    int size = 0;

    bool operator==(const ExemplarWindow&) const = default;
};

/// The pixels of a window.
PngPixels window_pixels(const PngPixels& exemplar, const ExemplarWindow& window);

/// Columns of the exemplar, from the first one to before the end, within which a window must lie.
struct ColumnRange
{
    int first = 0;
    int end = 0;
};

/// The columns of one of two exemplars side by side: of the one for marked corners, which begins at `split`, or of the
/// other; all columns where `split` is 0.
ColumnRange columns_of(const PngPixels& exemplar, int split, bool is_marked);

/// The number of columns of the narrower one.
int narrowest_columns(const PngPixels& exemplar, int split);

/// The windows of a set, and what is free beside them: middles of any two differ by the distance along an axis at
/// least.
class UsedWindows
{
public:
    explicit UsedWindows(int distance) : distance_(distance) {}

    bool is_free(const ExemplarWindow& window) const;
    void add(const ExemplarWindow& window) { windows_.push_back(window); }
    const std::vector<ExemplarWindow>& windows() const { return windows_; }
    int distance() const { return distance_; }

    /// A free window of this size, all of them equally likely as long as many are free.
    ExemplarWindow draw(const PngPixels& exemplar, ColumnRange columns, int size, RandomWords& words) const;
    ExemplarWindow draw(const PngPixels& exemplar, int size, RandomWords& words) const
    {
        return draw(exemplar, {0, exemplar.width}, size, words);
    }

    /// The free windows with the smallest sums, `apart` pixels from each other along an axis, the best first; ties by
    /// place. Fewer where there are no more. `ranges`: those that are allowed; none: all.
    std::vector<ExemplarWindow> best(const SquareSums& sums, int size, int count, int apart,
                                     std::span<const ColumnRange> ranges = {}) const;

    /// Returns what best() returns, or no window where none is free.
    std::vector<ExemplarWindow> free_best(const SquareSums& sums, int size, int count, int apart,
                                          std::span<const ColumnRange> ranges = {}) const;

private:
    int distance_;
    std::vector<ExemplarWindow> windows_;
};

/// The distance that so many windows of T x T pixels can have at least, whatever their order; at most T / 4. Given one
/// that is asked for, that; throws InputError where it is too large, with the number of windows that fit. Of two
/// exemplars side by side, `split` as above, the narrower one has to have room for all.
int window_distance(const PngPixels& exemplar, int size, std::size_t windows, std::optional<int> asked, int split = 0);

}
