#include "host/tile_sampling/penrose/penrose_importance.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace poissonlab {
namespace {

/// The nearest set so far.
class Nearest
{
public:
    explicit Nearest(std::size_t points) : points_(points) {}

    void offer(std::uint64_t importance, std::size_t found)
    {
        const std::size_t away = std::max(found, points_) - std::min(found, points_);
        if (away >= away_) return;
        away_ = away;
        importance_ = importance;
    }

    bool is_exact() const { return away_ == 0; }
    std::uint64_t importance() const { return importance_; }

private:
    std::size_t points_;
    std::size_t away_ = SIZE_MAX;
    std::uint64_t importance_ = 1;
};

/// Within a row no point moves, so that sets of smaller importances are parts of the row's last one.
void offer_row(const PenroseTiling& tiling, const ImportanceRange& row, std::size_t points, Nearest& nearest)
{
    std::vector<std::uint64_t> values;
    for (const PenrosePoint& point : reference::penrose_points(tiling, row.end - 1)) values.push_back(point.value);
    std::ranges::sort(values);
    const std::uint64_t wanted = points <= values.size() ? values[points - 1] + 1 : row.end - 1;
    const std::uint64_t importance = std::clamp(wanted, row.begin, row.end - 1);
    nearest.offer(importance, static_cast<std::size_t>(std::ranges::lower_bound(values, importance) - values.begin()));
}

std::uint64_t for_even_density(const PenroseTiling& tiling, std::size_t points, std::uint64_t guess)
{
    constexpr int rows_around = 2; // of 5 % more or fewer points each
    Nearest nearest(points);
    const PenroseRow middle = row_of_importance(tiling.scales, guess);
    const int number = static_cast<int>(middle.level) * contract::penrose::ROWS + static_cast<int>(middle.row);
    for (int step = 0; step <= 2 * rows_around && !nearest.is_exact(); ++step) {
        const int other = number + (step % 2 == 0 ? step / 2 : -(step + 1) / 2);
        if (other < 0) continue;
        const ImportanceRange range =
            importances_of(tiling.scales, {static_cast<std::size_t>(other) / contract::penrose::ROWS,
                                           static_cast<std::size_t>(other) % contract::penrose::ROWS});
        if (range.begin < range.end && range.end - 1 <= most_penrose_importance())
            offer_row(tiling, range, points, nearest);
    }
    return nearest.importance();
}

std::uint64_t for_density(const PenroseTiling& tiling, std::size_t points, std::uint64_t guess)
{
    constexpr int tries = 20;
    Nearest nearest(points);
    std::uint64_t low = 1, high = most_penrose_importance(), importance = guess;
    for (int i = 0; i < tries && !nearest.is_exact() && low < high; ++i) {
        const std::size_t found = reference::penrose_points(tiling, importance).size();
        nearest.offer(importance, found);
        if (found < points)
            low = importance + 1;
        else
            high = importance;
        // The next importance is in proportion to points at first; where that leads astray, the range is halved.
        const double next = static_cast<double>(importance) * static_cast<double>(points) /
                            static_cast<double>(std::max<std::size_t>(found, 1));
        const bool is_between = next >= static_cast<double>(low) && next < static_cast<double>(high);
        importance = i < tries / 2 && is_between ? static_cast<std::uint64_t>(next) : low + (high - low) / 2;
    }
    return nearest.importance();
}

}

std::uint64_t importance_for_points(const PenroseTiling& tiling, std::size_t points)
{
    const DensityBounds& density = tiling.density;
    const std::size_t pixels = std::size_t{density.width} * density.height;
    const double sum =
        std::accumulate(density.weights.begin(), density.weights.begin() + static_cast<std::ptrdiff_t>(pixels), 0.0);
    const double mean = sum / static_cast<double>(pixels) / static_cast<double>(full_weight);
    const double guess = static_cast<double>(points) / points_per_importance / mean + 1;
    if (guess > 0.9 * static_cast<double>(most_penrose_importance()))
        throw InputError(fmt::format("{} points in the {:.2g}th part of the square: tiles would have to be finer than "
                                     "level {}; fewer points, or a density that is less peaked",
                                     points, 1 / mean, int{contract::penrose::DEEPEST}));
    const auto start = static_cast<std::uint64_t>(guess);
    return pixels == 1 ? for_even_density(tiling, points, start) : for_density(tiling, points, start);
}

}
