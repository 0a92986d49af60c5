#include "host/sampling/optimized/torus_map.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Adds tap * (a + b) to a row.
void add_pair(double* row, std::size_t size, double tap, const double* a, const double* b)
{
    for (std::size_t i = 0; i < size; ++i) row[i] += tap * (a[i] + b[i]);
}

void blur_rows(TorusMap& map, const std::vector<double>& taps)
{
    const std::size_t n = map.size, reach = taps.size() - 1;
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t row) {
        std::vector<double> padded(n + 2 * reach);
        for (std::size_t i = 0; i < padded.size(); ++i) padded[i] = map.at((i + n - reach) % n, row);
        double* sums = map.values.data() + row * n;
        for (std::size_t i = 0; i < n; ++i) sums[i] = taps[0] * padded[i + reach];
        for (std::size_t k = 1; k <= reach; ++k)
            add_pair(sums, n, taps[k], padded.data() + reach - k, padded.data() + reach + k);
    });
}

TorusMap blurred_columns(const TorusMap& map, const std::vector<double>& taps)
{
    const std::size_t n = map.size, reach = taps.size() - 1;
    TorusMap result{n, std::vector<double>(n * n)};
    const auto row_at = [&](std::size_t row) { return map.values.data() + row % n * n; };
    tbb::parallel_for(std::size_t{0}, n, [&](std::size_t row) {
        double* sums = result.values.data() + row * n;
        for (std::size_t i = 0; i < n; ++i) sums[i] = taps[0] * map.at(i, row);
        for (std::size_t k = 1; k <= reach; ++k) add_pair(sums, n, taps[k], row_at(row + n - k), row_at(row + k));
    });
    return result;
}

double slope(double two_before, double before, double after, double two_after, std::size_t size)
{
    return (8 * (after - before) - (two_after - two_before)) / 12 * static_cast<double>(size);
}

/// `value`: of a column and a row.
TorusMap map_of(std::size_t size, const auto& value)
{
    TorusMap map{size, std::vector<double>(size * size)};
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t row) {
        for (std::size_t i = 0; i < size; ++i) map.values[row * size + i] = value(i, row);
    });
    return map;
}

}

double TorusMap::between(double x, double y) const
{
    const auto n = static_cast<double>(size);
    const double left = std::floor(x * n - 0.5), low = std::floor(y * n - 0.5);
    const double part_x = x * n - 0.5 - left, part_y = y * n - 0.5 - low;
    const auto wrapped = [&](double cell) {
        return static_cast<std::size_t>(cell < 0 ? cell + n : cell < n ? cell : cell - n);
    };
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
    return map_of(map.size / 2, [&](std::size_t column, std::size_t row) {
        const std::size_t i = 2 * column, j = 2 * row;
        return ((map.at(i, j) + map.at(i + 1, j)) + (map.at(i, j + 1) + map.at(i + 1, j + 1))) / 4;
    });
}

TorusMap slope_along_x(const TorusMap& map)
{
    const std::size_t n = map.size;
    return map_of(n, [&](std::size_t i, std::size_t row) {
        return slope(map.at((i + n - 2) % n, row), map.at((i + n - 1) % n, row), map.at((i + 1) % n, row),
                     map.at((i + 2) % n, row), n);
    });
}

TorusMap slope_along_y(const TorusMap& map)
{
    const std::size_t n = map.size;
    return map_of(n, [&](std::size_t i, std::size_t row) {
        return slope(map.at(i, (row + n - 2) % n), map.at(i, (row + n - 1) % n), map.at(i, (row + 1) % n),
                     map.at(i, (row + 2) % n), n);
    });
}

}
