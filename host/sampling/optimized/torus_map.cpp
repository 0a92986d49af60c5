#include "host/sampling/optimized/torus_map.hpp"

#include <cmath>

namespace poissonlab {
namespace {

/// exp(-t) for small t, by its series.
double decay(double t)
{
    double sum = 1;
    for (int n = 20; n > 0; --n) sum = 1 - t / n * sum;
    return sum;
}

/// exp(-k^2 / (2 sigma^2)) for k from 0 to six sigma, each over the sum of all on both sides.
std::vector<double> gaussian_taps(double sigma)
{
    const double first = decay(1 / (2 * sigma * sigma));
    std::vector<double> taps{1};
    double sum = 1, ratio = first;
    while (static_cast<double>(taps.size()) <= 6 * sigma) {
        taps.push_back(taps.back() * ratio);
        sum += 2 * taps.back();
        ratio *= first * first;
    }
    for (double& tap : taps) tap /= sum;
    return taps;
}

/// Adds tap * (a + b) to a row.
void add_pair(std::vector<double>& row, double tap, const double* a, const double* b)
{
    for (std::size_t i = 0; i < row.size(); ++i) row[i] += tap * (a[i] + b[i]);
}

void blur_rows(TorusMap& map, const std::vector<double>& taps)
{
    const std::size_t n = map.size, reach = taps.size() - 1;
    std::vector<double> padded(n + 2 * reach), sums(n);
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t i = 0; i < padded.size(); ++i) padded[i] = map.at((i + n - reach) % n, row);
        for (std::size_t i = 0; i < n; ++i) sums[i] = taps[0] * padded[i + reach];
        for (std::size_t k = 1; k <= reach; ++k)
            add_pair(sums, taps[k], padded.data() + reach - k, padded.data() + reach + k);
        for (std::size_t i = 0; i < n; ++i) map.values[row * n + i] = sums[i];
    }
}

TorusMap blurred_columns(const TorusMap& map, const std::vector<double>& taps)
{
    const std::size_t n = map.size, reach = taps.size() - 1;
    TorusMap result{n, {}};
    result.values.reserve(map.values.size());
    std::vector<double> sums(n);
    const auto row_at = [&](std::size_t row) { return map.values.data() + row % n * n; };
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t i = 0; i < n; ++i) sums[i] = taps[0] * map.at(i, row);
        for (std::size_t k = 1; k <= reach; ++k) add_pair(sums, taps[k], row_at(row + n - k), row_at(row + k));
        result.values.insert(result.values.end(), sums.begin(), sums.end());
    }
    return result;
}

double slope(double two_before, double before, double after, double two_after, std::size_t size)
{
    return (8 * (after - before) - (two_after - two_before)) / 12 * static_cast<double>(size);
}

}

double TorusMap::between(double x, double y) const
{
    const auto n = static_cast<double>(size);
    const double left = std::floor(x * n - 0.5), low = std::floor(y * n - 0.5);
    const double part_x = x * n - 0.5 - left, part_y = y * n - 0.5 - low;
    const auto wrapped = [&](double cell) { return static_cast<std::size_t>(cell + n) % size; };
    const auto along_row = [&](double row) {
        const std::size_t r = wrapped(row);
        return at(wrapped(left), r) * (1 - part_x) + at(wrapped(left + 1), r) * part_x;
    };
    return along_row(low) * (1 - part_y) + along_row(low + 1) * part_y;
}

TorusMap blurred(const TorusMap& map, double sigma)
{
    const std::vector<double> taps = gaussian_taps(sigma);
    TorusMap rows = map;
    blur_rows(rows, taps);
    return blurred_columns(rows, taps);
}

TorusMap halved(const TorusMap& map)
{
    TorusMap half{map.size / 2, {}};
    for (std::size_t row = 0; row < map.size; row += 2)
        for (std::size_t column = 0; column < map.size; column += 2)
            half.values.push_back(((map.at(column, row) + map.at(column + 1, row)) +
                                   (map.at(column, row + 1) + map.at(column + 1, row + 1))) /
                                  4);
    return half;
}

TorusMap slope_along_x(const TorusMap& map)
{
    const std::size_t n = map.size;
    TorusMap slopes{n, {}};
    for (std::size_t row = 0; row < n; ++row)
        for (std::size_t i = 0; i < n; ++i)
            slopes.values.push_back(slope(map.at((i + n - 2) % n, row), map.at((i + n - 1) % n, row),
                                          map.at((i + 1) % n, row), map.at((i + 2) % n, row), n));
    return slopes;
}

TorusMap slope_along_y(const TorusMap& map)
{
    const std::size_t n = map.size;
    TorusMap slopes{n, {}};
    for (std::size_t row = 0; row < n; ++row)
        for (std::size_t i = 0; i < n; ++i)
            slopes.values.push_back(slope(map.at(i, (row + n - 2) % n), map.at(i, (row + n - 1) % n),
                                          map.at(i, (row + 1) % n), map.at(i, (row + 2) % n), n));
    return slopes;
}

}
