#include "host/distribution/discrepancy.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {

std::vector<double> l2_star_discrepancies(const PointSet& points, const std::vector<std::size_t>& counts)
{
    std::vector<double> found, x, y;
    double singles = 0, pairs = 0;
    for (const std::size_t count : counts) {
        for (std::size_t n = x.size(); n < count; ++n) {
            const double u = points[n][0], v = points[n][1];
            double sum = 0;
            for (std::size_t i = 0; i < n; ++i) sum += (1 - std::max(u, x[i])) * (1 - std::max(v, y[i]));
            pairs += 2 * sum + (1 - u) * (1 - v);
            singles += (1 - u * u) * (1 - v * v);
            x.push_back(u);
            y.push_back(v);
        }
        const auto n = static_cast<double>(count);
        found.push_back(std::sqrt(std::max(0.0, 1.0 / 9 - singles / (2 * n) + pairs / (n * n))));
    }
    return found;
}

double star_discrepancy(const PointSet& points, std::size_t count)
{
    // The largest difference is at a box whose sides are coordinates of points or 1: of too many points with them on
    // the border inside, of too few with them outside.
    std::vector<std::size_t> by_x(count);
    std::iota(by_x.begin(), by_x.end(), 0U);
    std::ranges::stable_sort(by_x, {}, [&](std::size_t i) { return points[i][0]; });
    std::vector<double> heights{1};
    for (std::size_t i = 0; i < count; ++i) heights.push_back(points[i][1]);
    std::ranges::sort(heights);
    const auto n = static_cast<double>(count);
    std::vector<double> below(heights.size()), up_to(heights.size()); // points with smaller x
    double largest = 0;
    std::size_t next = 0;
    const auto compare = [&](double x, const std::vector<double>& counted, double sign) {
        for (std::size_t j = 0; j < heights.size(); ++j)
            largest = std::max(largest, sign * (counted[j] / n - x * heights[j]));
    };
    while (next < count) {
        const double x = points[by_x[next]][0];
        compare(x, below, -1);
        for (; next < count && points[by_x[next]][0] == x; ++next)
            for (std::size_t j = 0; j < heights.size(); ++j) {
                const double y = points[by_x[next]][1];
                below[j] += y < heights[j] ? 1 : 0;
                up_to[j] += y <= heights[j] ? 1 : 0;
            }
        compare(x, up_to, 1);
    }
    compare(1, below, -1);
    return largest;
}

}
