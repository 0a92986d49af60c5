#include "host/texture/endless/gaussian_exemplar.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

using namespace contract::endless_texture;

constexpr int axis_unit = 1 << 14; ///< axes are rounded to so many parts: coordinates are whole numbers of these

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix covariance(const PngPixels& exemplar, const std::array<double, 3>& means)
{
    Matrix sums{};
    for (std::size_t i = 0; i < exemplar.values.size(); i += 3)
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                sums[a][b] += (exemplar.values[i + a] - means[a]) * (exemplar.values[i + b] - means[b]);
    return sums;
}

/// Turns the plane of two axes so that their covariance vanishes.
void turn(Matrix& covariances, Matrix& axes, std::size_t p, std::size_t q)
{
    if (covariances[p][q] == 0) return;
    const double theta = (covariances[q][q] - covariances[p][p]) / (2 * covariances[p][q]);
    const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
    const double c = 1 / std::sqrt(t * t + 1), s = t * c;
    for (std::size_t k = 0; k < 3; ++k) {
        const double kp = covariances[k][p], kq = covariances[k][q];
        covariances[k][p] = c * kp - s * kq;
        covariances[k][q] = s * kp + c * kq;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double pk = covariances[p][k], qk = covariances[q][k], ap = axes[p][k], aq = axes[q][k];
        covariances[p][k] = c * pk - s * qk;
        covariances[q][k] = s * pk + c * qk;
        axes[p][k] = c * ap - s * aq;
        axes[q][k] = s * ap + c * aq;
    }
}

/// The principal axes in rows, by Jacobi's rotations: sums, products, quotients and roots, the same everywhere.
Matrix principal_axes(Matrix covariances)
{
    Matrix axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < 12; ++sweep)
        for (const auto& [p, q] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}})
            turn(covariances, axes, p, q);
    return axes;
}

/// Coordinates of one axis, whole numbers of levels over axis_unit.
std::vector<std::int32_t> coordinates_along(const PngPixels& exemplar, const std::array<std::int32_t, 3>& axis)
{
    const auto channels = static_cast<std::size_t>(exemplar.channels);
    std::vector<std::int32_t> values(exemplar.values.size() / channels);
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t c = 0; c < channels; ++c) values[i] += axis[c] * exemplar.values[i * channels + c];
    return values;
}

/// Sums over squares of 2 reach + 1 pixels around each one, of what of them is inside.
std::vector<std::int64_t> neighborhood_sums(const std::vector<std::int32_t>& values, int width, int height, int reach)
{
    std::vector<std::int64_t> sums;
    sums.reserve(values.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            std::int64_t sum = 0;
            for (int j = std::max(0, y - reach); j <= std::min(height - 1, y + reach); ++j)
                for (int i = std::max(0, x - reach); i <= std::min(width - 1, x + reach); ++i)
                    sum += values[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(i)];
            sums.push_back(sum);
        }
    return sums;
}

/// Pixels from the smallest value to the largest one.
std::vector<std::uint32_t> pixels_in_order(const std::vector<std::int32_t>& values, int width, int height)
{
    const auto near = neighborhood_sums(values, width, height, 1), far = neighborhood_sums(values, width, height, 2);
    std::vector<std::uint32_t> order(values.size()), ties(values.size());
    std::iota(order.begin(), order.end(), 0u);
    for (std::uint32_t i = 0; i < ties.size(); ++i) ties[i] = i * 0x9e3779b1u; // odd: no two are equal
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        if (values[a] != values[b]) return values[a] < values[b];
        if (near[a] != near[b]) return near[a] < near[b];
        if (far[a] != far[b]) return far[a] < far[b];
        return ties[a] < ties[b];
    });
    return order;
}

double deviations_of(double number)
{
    return (number - static_cast<double>(GAUSSIAN_ZERO)) / static_cast<double>(GAUSSIAN_STEPS);
}

/// The numbers of ranks 0, 1, ...: the k-th has the quantile (k + 1/2) / count, to the nearest number.
std::vector<std::uint16_t> numbers_of_ranks(std::size_t count)
{
    std::vector<std::uint16_t> numbers;
    numbers.reserve(count);
    std::size_t rank = 0;
    for (int number = 0; number < 65'536; ++number) {
        const double upper = number == 65'535 ? 2 : normal_probability(deviations_of(number + 0.5));
        for (; rank < count && (static_cast<double>(rank) + 0.5) / static_cast<double>(count) <= upper; ++rank)
            numbers.push_back(static_cast<std::uint16_t>(number));
    }
    return numbers;
}

}

std::array<double, 3> channel_means(const PngPixels& picture)
{
    std::array<double, 3> means{};
    const double pixels = static_cast<double>(picture.width) * picture.height;
    for (int c = 0; c < picture.channels; ++c) {
        std::int64_t sum = 0;
        for (std::size_t i = static_cast<std::size_t>(c); i < picture.values.size();
             i += static_cast<std::size_t>(picture.channels))
            sum += picture.values[i];
        means[static_cast<std::size_t>(c)] = static_cast<double>(sum) / pixels;
    }
    return means;
}

GaussianExemplar gaussian_exemplar(const PngPixels& exemplar)
{
    GaussianExemplar result;
    result.channels = exemplar.channels;
    const auto channels = static_cast<std::size_t>(exemplar.channels);
    const std::array<double, 3> means = channel_means(exemplar);
    Matrix axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (channels == 3) axes = principal_axes(covariance(exemplar, means));
    for (std::size_t c = 0; c < channels; ++c) result.means[c] = static_cast<float>(means[c]);

    const std::vector<std::uint16_t> of_ranks = numbers_of_ranks(exemplar.values.size() / channels);
    result.numbers.resize(exemplar.values.size());
    for (std::size_t k = 0; k < channels; ++k) {
        std::array<std::int32_t, 3> axis{};
        double middle = 0; // the coordinate of the mean colour
        for (std::size_t c = 0; c < channels; ++c) {
            axis[c] = static_cast<std::int32_t>(std::lround(axes[k][c] * axis_unit));
            result.axes[3 * k + c] = static_cast<float>(axis[c]) / axis_unit;
            middle += axis[c] * means[c];
        }
        const std::vector<std::int32_t> values = coordinates_along(exemplar, axis);
        const std::vector<std::uint32_t> order = pixels_in_order(values, exemplar.width, exemplar.height);
        for (std::size_t rank = 0; rank < order.size(); ++rank)
            result.numbers[order[rank] * channels + k] = of_ranks[rank];
        constexpr int step = 65'536 / INVERSE_ENTRIES;
        for (int entry = 0; entry < INVERSE_ENTRIES; ++entry) {
            const double below = normal_probability(deviations_of(entry * step + step / 2.0));
            const auto rank = static_cast<std::size_t>(below * static_cast<double>(order.size()));
            const double value = values[order[std::min(rank, order.size() - 1)]];
            result.inverse.push_back(static_cast<float>((value - middle) / axis_unit));
        }
    }
    return result;
}

namespace {

/// exp(-v) for v from 0 to 32, by its series of a 64th part, squared six times.
double exponential_decay(double v)
{
    const double part = -v / 64;
    double term = 1, sum = 1;
    for (int n = 1; n <= 20; ++n) {
        term *= part / n;
        sum += term;
    }
    for (int i = 0; i < 6; ++i) sum *= sum;
    return sum;
}

constexpr double root_of_two_pi = 2.5066282746310005024;

/// The probability of more than x deviations, for x of 3 and more: Laplace's continued fraction.
double upper_tail(double x)
{
    double fraction = x;
    for (int k = 120; k >= 1; --k) fraction = x + k / fraction;
    return exponential_decay(x * x / 2) / root_of_two_pi / fraction;
}

}

double normal_probability(double deviations)
{
    const double x = deviations < 0 ? -deviations : deviations;
    if (x >= 3) return deviations < 0 ? upper_tail(x) : 1 - upper_tail(x);
    // Phi(x) = 1/2 + phi(x) (x + x^3 / 3 + x^5 / (3 5) + ...)
    double term = x, sum = x;
    for (int n = 1; n <= 80; ++n) {
        term *= x * x / (2 * n + 1);
        sum += term;
    }
    const double half = exponential_decay(x * x / 2) / root_of_two_pi * sum;
    return deviations < 0 ? 0.5 - half : 0.5 + half;
}

}
