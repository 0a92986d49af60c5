#include "host/texture/joint/window_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace poissonlab {
namespace {

/// The windows that are compared pixel by pixel, for each that is asked for.
constexpr int looked_at = 3;

/// Windows that are nearer show nearly the same.
constexpr int least_distance = 4;

PieceMask coarse_mask(int side, const std::vector<std::uint8_t>& counts)
{
    PieceMask mask{side / 2, side / 2, {}};
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            mask.counts.push_back(counts.empty() ? 1 : counts[static_cast<std::size_t>(2 * y * side + 2 * x)]);
    return mask;
}

/// The sum of squared differences of values, at most 65,536 of them.
std::uint32_t squared_distance(const std::uint8_t* a, const std::uint8_t* b, std::size_t count)
{
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int difference = a[i] - b[i];
        sum += static_cast<std::uint32_t>(difference * difference);
    }
    return sum;
}

/// The sum of squared differences of the values whose factor is 1; the other factors are 0.
std::uint32_t squared_distance(const std::uint8_t* a, const std::uint8_t* b, std::size_t count,
                               const std::uint8_t* factors)
{
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int difference = (a[i] - b[i]) * factors[i];
        sum += static_cast<std::uint32_t>(difference * difference);
    }
    return sum;
}

bool is_near(const ExemplarWindow& a, const ExemplarWindow& b)
{
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) < least_distance;
}

}

PngPixels halved(const PngPixels& picture)
{
    PngPixels half{picture.width / 2, picture.height / 2, picture.channels, {}};
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
            for (int c = 0; c < picture.channels; ++c) {
                int sum = 2;
                for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)})
                    sum += picture.values[picture.at(2 * x + dx, 2 * y + dy, c)];
                half.values.push_back(static_cast<std::uint8_t>(sum / 4));
            }
    return half;
}

WindowTest window_test(const PhaseRule& rule, double x, double y)
{
    if (rule.is_empty()) return {};
    return [&rule, x, y](const ExemplarWindow& window, double slack) { return rule.holds(window, x, y, slack); };
}

WindowSearch::WindowSearch(const PngPixels& features, int side, const std::vector<std::uint8_t>& counts)
    : features_(features), side_(side), squares_(halved(features), coarse_mask(side, counts))
{
    for (const std::uint8_t is_counted : counts)
        factors_.insert(factors_.end(), static_cast<std::size_t>(features.channels), is_counted == 0 ? 0 : 1);
}

std::uint64_t WindowSearch::difference(const PngPixels& canvas, const ExemplarWindow& window) const
{
    std::uint64_t sum = 0;
    const auto row_values = static_cast<std::size_t>(side_ * features_.channels);
    for (int y = 0; y < side_; ++y) {
        const std::size_t first = canvas.at(0, y, 0);
        const std::uint8_t* const there = &features_.values[features_.at(window.x, window.y + y, 0)];
        sum += factors_.empty() ? squared_distance(&canvas.values[first], there, row_values)
                                : squared_distance(&canvas.values[first], there, row_values, &factors_[first]);
    }
    return sum;
}

/// Sums at half the resolution, the largest possible ones where no window near a place is allowed.
SquareSums WindowSearch::coarse_sums(const PngPixels& canvas, const WindowTest& is_allowed) const
{
    SquareSums sums = squares_.sums(halved(canvas));
    if (!is_allowed) return sums;
    std::size_t place = 0;
    for (int y = 0; y < sums.rows; ++y)
        for (int x = 0; x < sums.columns; ++x, ++place)
            if (!is_allowed({2 * x, 2 * y, side_}, 1)) sums.sums[place] = std::numeric_limits<std::uint64_t>::max();
    return sums;
}

std::vector<ExemplarWindow> WindowSearch::best(const PngPixels& canvas, const UsedWindows& used,
                                               const std::vector<ExemplarWindow>& shown, int count,
                                               const WindowTest& is_allowed) const
{
    const SquareSums sums = coarse_sums(canvas, is_allowed);
    UsedWindows coarse_used(used.distance() / 2);
    for (const ExemplarWindow& window : used.windows()) coarse_used.add({window.x / 2, window.y / 2, window.size / 2});
    const int most = looked_at * count + static_cast<int>(shown.size());
    std::vector<std::pair<std::uint64_t, ExemplarWindow>> found;
    for (const ExemplarWindow& coarse : coarse_used.free_best(sums, side_ / 2, most, 2)) {
        std::pair<std::uint64_t, ExemplarWindow> best{std::numeric_limits<std::uint64_t>::max(), {}};
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const ExemplarWindow window{2 * coarse.x + dx, 2 * coarse.y + dy, side_};
                if (window.x < 0 || window.y < 0 || window.x + side_ > features_.width ||
                    window.y + side_ > features_.height || !used.is_free(window) ||
                    (is_allowed && !is_allowed(window, 0)) ||
                    std::ranges::any_of(shown, [&](const ExemplarWindow& other) { return is_near(other, window); }))
                    continue;
                if (const std::uint64_t its = difference(canvas, window); its < best.first) best = {its, window};
            }
        const auto is_known = [&](const auto& other) { return is_near(other.second, best.second); };
        if (best.second.size > 0 && std::ranges::none_of(found, is_known)) found.push_back(best);
    }
    std::ranges::stable_sort(found, {}, [](const auto& each) { return each.first; });
    std::vector<ExemplarWindow> windows;
    for (const auto& [difference, window] : found)
        if (static_cast<int>(windows.size()) < count) windows.push_back(window);
    return windows;
}

}
