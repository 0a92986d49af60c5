#include "host/texture/window_choice.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace poissonlab {
namespace {

/// Twice the distance of middles along the axis where it is larger.
int doubled_distance(const ExemplarWindow& a, const ExemplarWindow& b)
{
    return std::max(std::abs(2 * a.x + a.size - 2 * b.x - b.size), std::abs(2 * a.y + a.size - 2 * b.y - b.size));
}

/// Marks the corners of windows of a size whose middles are nearer to a window's than the distance; from which to which
/// row they may lie.
std::pair<int, int> forbid(std::vector<std::uint64_t>& sums, const SquareSums& shape, int size,
                           const ExemplarWindow& used, int distance)
{
    // |2 x + size - m| < 2 d, m twice the middle.
    const auto range = [&](int doubled_middle, int count) {
        const int first = (doubled_middle - size - 2 * distance) / 2;
        const int last = (doubled_middle - size + 2 * distance) / 2;
        return std::pair(std::max(first - 1, 0), std::min(last + 1, count - 1));
    };
    const auto [left, right] = range(2 * used.x + used.size, shape.columns);
    const auto [top, bottom] = range(2 * used.y + used.size, shape.rows);
    for (int y = top; y <= bottom; ++y)
        for (int x = left; x <= right; ++x)
            if (doubled_distance({x, y, size}, used) < 2 * distance)
                sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.columns) +
                     static_cast<std::size_t>(x)] = std::numeric_limits<std::uint64_t>::max();
    return {top, bottom};
}

/// The smallest sum of each row: of many smallest ones, each costs a look at few rows.
class RowMinima
{
public:
    RowMinima(const std::vector<std::uint64_t>& sums, const SquareSums& shape)
        : sums_(sums), columns_(shape.columns), minima_(static_cast<std::size_t>(shape.rows))
    {
        update({0, shape.rows - 1});
    }

    /// The first place, row by row, with the smallest sum of all.
    std::pair<int, int> place() const
    {
        const auto row = std::ranges::min_element(minima_) - minima_.begin();
        const auto values = row_of(static_cast<int>(row));
        return {static_cast<int>(std::ranges::min_element(values) - values.begin()), static_cast<int>(row)};
    }

    std::uint64_t smallest() const { return *std::ranges::min_element(minima_); }

    void update(std::pair<int, int> rows)
    {
        for (int row = rows.first; row <= rows.second; ++row)
            minima_[static_cast<std::size_t>(row)] = *std::ranges::min_element(row_of(row));
    }

private:
    std::span<const std::uint64_t> row_of(int row) const
    {
        const auto columns = static_cast<std::size_t>(columns_);
        return std::span(sums_).subspan(static_cast<std::size_t>(row) * columns, columns);
    }

    const std::vector<std::uint64_t>& sums_;
    int columns_;
    std::vector<std::uint64_t> minima_;
};

/// Marks the corners of windows that lie in none of the ranges.
void forbid_outside(std::vector<std::uint64_t>& sums, const SquareSums& shape, int size,
                    std::span<const ColumnRange> ranges)
{
    for (int x = 0; x < shape.columns; ++x) {
        const auto holds = [&](const ColumnRange& range) { return x >= range.first && x + size <= range.end; };
        if (std::ranges::any_of(ranges, holds)) continue;
        for (int y = 0; y < shape.rows; ++y)
            sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(shape.columns) + static_cast<std::size_t>(x)] =
                std::numeric_limits<std::uint64_t>::max();
    }
}

}

PngPixels window_pixels(const PngPixels& exemplar, const ExemplarWindow& window)
{
    PngPixels pixels{window.size, window.size, exemplar.channels, {}};
    for (int row = 0; row < window.size; ++row) {
        const auto first =
            exemplar.values.begin() + static_cast<std::ptrdiff_t>(exemplar.at(window.x, window.y + row, 0));
        pixels.values.insert(pixels.values.end(), first, first + window.size * exemplar.channels);
    }
    return pixels;
}

bool UsedWindows::is_free(const ExemplarWindow& window) const
{
    return std::ranges::none_of(
        windows_, [&](const ExemplarWindow& used) { return doubled_distance(used, window) < 2 * distance_; });
}

ExemplarWindow UsedWindows::draw(const PngPixels& exemplar, ColumnRange range, int size, RandomWords& words) const
{
    const auto columns = static_cast<std::uint32_t>(range.end - range.first - size + 1);
    const auto rows = static_cast<std::uint32_t>(exemplar.height - size + 1);
    constexpr int most_tries = 1000;
    ExemplarWindow window{0, 0, size};
    for (int i = 0; i < most_tries; ++i) {
        window.x = range.first + static_cast<int>(words.below(columns));
        window.y = static_cast<int>(words.below(rows));
        if (is_free(window)) return window;
    }
    for (window.y = 0; window.y < static_cast<int>(rows); ++window.y)
        for (window.x = range.first; window.x < range.first + static_cast<int>(columns); ++window.x)
            if (is_free(window)) return window;
    throw std::logic_error("no window is free");
}

std::vector<ExemplarWindow> UsedWindows::best(const SquareSums& sums, int size, int count, int apart,
                                              std::span<const ColumnRange> ranges) const
{
    std::vector<ExemplarWindow> windows = free_best(sums, size, count, apart, ranges);
    if (windows.empty()) throw std::logic_error("no window is free");
    return windows;
}

std::vector<ExemplarWindow> UsedWindows::free_best(const SquareSums& sums, int size, int count, int apart,
                                                   std::span<const ColumnRange> ranges) const
{
    std::vector<std::uint64_t> left = sums.sums;
    if (!ranges.empty()) forbid_outside(left, sums, size, ranges);
    for (const ExemplarWindow& used : windows_) forbid(left, sums, size, used, distance_);
    std::vector<ExemplarWindow> windows;
    RowMinima minima(left, sums);
    while (static_cast<int>(windows.size()) < count && minima.smallest() != std::numeric_limits<std::uint64_t>::max()) {
        const auto [x, y] = minima.place();
        windows.push_back({x, y, size});
        minima.update(forbid(left, sums, size, windows.back(), apart));
    }
    return windows;
}

ColumnRange columns_of(const PngPixels& exemplar, int split, bool is_marked)
{
    if (split == 0) return {0, exemplar.width};
    return is_marked ? ColumnRange{split, exemplar.width} : ColumnRange{0, split};
}

int narrowest_columns(const PngPixels& exemplar, int split)
{
    return split == 0 ? exemplar.width : std::min(split, exemplar.width - split);
}

int window_distance(const PngPixels& exemplar, int size, std::size_t windows, std::optional<int> asked, int split)
{
    const int width = narrowest_columns(exemplar, split);
    // Each window forbids at most (2 d - 1)^2 corners of others, a pixel more along each axis where sizes differ.
    const double corners = static_cast<double>(width - size + 1) * (exemplar.height - size + 1);
    const auto fitting = [&](int distance) {
        return distance == 0 ? std::numeric_limits<double>::infinity() : corners / (4.0 * distance * distance);
    };
    if (asked) {
        if (static_cast<double>(windows) > fitting(*asked))
            throw invalid_value({}, "diversity", fmt::format("{}", *asked),
                                fmt::format("{} windows are needed, of which {:.0f} are sure to fit into an "
                                            "exemplar of {} x {} pixels",
                                            windows, std::floor(fitting(*asked)), width, exemplar.height));
        return *asked;
    }
    int distance = size / 4;
    while (distance > 0 && static_cast<double>(windows) > fitting(distance)) --distance;
    return distance;
}

}
