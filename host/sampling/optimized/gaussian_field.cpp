#include "host/sampling/optimized/gaussian_field.hpp"

#include "host/sampling/optimized/torus_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using contract::gaussian_blue_noise::FIELD_CELLS;

__extension__ using WideSum = __int128;

constexpr std::uint32_t least_field_size = 64, most_field_size = 2048;

/// 2^(i / parts) for 2 or 4 parts, exact where it is a power of two.
double root_power(int i, int parts)
{
    const double root = std::sqrt(2.0);
    const std::array<double, 4> roots =
        parts == 2 ? std::array{1.0, root, 0.0, 0.0} : std::array{1.0, std::sqrt(root), root, root * std::sqrt(root)};
    const int rest = (i % parts + parts) % parts;
    return std::ldexp(roots[static_cast<std::size_t>(rest)], (i - rest) / parts);
}

WideSum sum_of_weights(const Density& density)
{
    WideSum sum = 0;
    for (const std::uint64_t weight : density.weights) sum += weight;
    return sum;
}

/// Each pixel minus the mean, in parts of the mean: 0 everywhere in a constant density.
std::vector<double> deviations(const Density& density)
{
    const WideSum sum = sum_of_weights(density);
    std::vector<double> all;
    all.reserve(density.weights.size());
    for (const std::uint64_t weight : density.weights)
        all.push_back(static_cast<double>(static_cast<WideSum>(weight) * density.weights.size() - sum) /
                      static_cast<double>(sum));
    return all;
}

/// Means over `size` equal parts of a row of numbers that are `stride` apart.
void resample_row(const double* values, std::size_t count, std::size_t stride, std::size_t size, double* means)
{
    for (std::size_t cell = 0; cell < size; ++cell) {
        // In parts of a number over size: cell covers from cell * count to (cell + 1) * count.
        const std::size_t begin = cell * count, end = begin + count;
        double sum = 0;
        for (std::size_t i = begin / size; i * size < end; ++i) {
            const std::size_t overlap = std::min(end, (i + 1) * size) - std::max(begin, i * size);
            sum += values[i * stride] * static_cast<double>(overlap);
        }
        means[cell] = sum / static_cast<double>(count);
    }
}

TorusMap resampled(const std::vector<double>& pixels, std::size_t width, std::size_t size)
{
    std::vector<double> rows(width * size);
    for (std::size_t row = 0; row < width; ++row)
        resample_row(pixels.data() + row * width, width, 1, size, rows.data() + row * size);
    TorusMap map{size, std::vector<double>(size * size)};
    std::vector<double> column(size);
    for (std::size_t i = 0; i < size; ++i) {
        resample_row(rows.data() + i, width, size, size, column.data());
        for (std::size_t row = 0; row < size; ++row) map.values[row * size + i] = column[row];
    }
    return map;
}

/// The density blurred by one width after the other, on coarser and coarser grids.
class BlurLadder
{
public:
    /// `narrowest` is the standard deviation of the first width; of the torus' side.
    BlurLadder(TorusMap map, double narrowest) : map_(std::move(map)) { blur_to(narrowest); }

    /// Widens the blur to this standard deviation.
    void blur_to(double sigma)
    {
        const double more = std::sqrt(sigma * sigma - sigma_ * sigma_) * static_cast<double>(map_.size);
        map_ = blurred(map_, more);
        sigma_ = sigma;
        if (sigma * static_cast<double>(map_.size) >= 8 && map_.size > least_field_size) map_ = halved(map_);
    }

    const TorusMap& map() const { return map_; }

private:
    TorusMap map_;
    double sigma_ = 0;
};

/// The density blurred by one width.
struct BlurredDensity
{
    double squared = 1; ///< of the width, over sigma
    TorusMap deviation, slope_x, slope_y;
};

/// The numbers of the Gaussian at a place.
struct PlaceNumbers : GaussianNumbers
{
    double enough = 1; ///< as `under`, or as if the density were that of the place; 1 where it is wide enough

    /// `own_deviation`: of the density of the place.
    PlaceNumbers(const BlurredDensity& density, double own_deviation, double at_x, double at_y)
    {
        squared = density.squared;
        under = squared * (1 + density.deviation.between(at_x, at_y));
        enough = std::max(under, squared * (1 + own_deviation));
    }

    /// Slopes are read last: most Gaussians are not wide enough, and need none.
    void read_slopes(const BlurredDensity& density, double at_x, double at_y)
    {
        slope_x = density.slope_x.between(at_x, at_y);
        slope_y = density.slope_y.between(at_x, at_y);
    }

    /// Turns the numbers of a Gaussian that is wide enough into those of one between it and a narrower one that is not:
    /// the narrowest that is wide enough.
    void narrow_towards(const PlaceNumbers& narrower)
    {
        GaussianNumbers::operator=(between(narrower, *this, (1 - narrower.enough) / (enough - narrower.enough)));
        enough = 1;
    }
};

/// Gives the cells of a field their numbers, from narrow to wide.
class WidthChooser
{
public:
    /// `own`: the density as it is, with a value for each cell of the field.
    WidthChooser(GaussianField& field, const TorusMap& own, double sigma, double step, std::size_t points)
        : field_(field), own_(own), sigma_(sigma), step_(step), points_(static_cast<double>(points)),
          is_done_(field.cells.size())
    {}

    /// Takes the cells that a Gaussian of this number is wide enough for, or all that are left. `deviation`: the
    /// density, so blurred.
    void choose(int number, const TorusMap& deviation, bool is_last)
    {
        BlurredDensity density{root_power(number, 2), deviation, slope_along_x(deviation), slope_along_y(deviation)};
        const std::size_t size = field_.shape.size;
        tbb::parallel_for(std::size_t{0}, size, [&](std::size_t row) {
            for (std::size_t i = row * size; i < (row + 1) * size; ++i)
                if (!is_done_[i]) choose_for(i, number, density, is_last);
        });
        narrower_ = std::move(density);
    }

private:
    void choose_for(std::size_t i, int number, const BlurredDensity& density, bool is_last)
    {
        const auto size = static_cast<double>(field_.shape.size);
        const double x = (static_cast<double>(i % field_.shape.size) + 0.5) / size;
        const double y = (static_cast<double>(i / field_.shape.size) + 0.5) / size;
        PlaceNumbers numbers(density, own_.values[i], x, y);
        if (numbers.enough < 1 && !is_last) return;
        numbers.read_slopes(density, x, y);
        if (numbers.enough > 1 && number > field_.shape.narrowest) {
            PlaceNumbers narrower(narrower_, own_.values[i], x, y);
            narrower.read_slopes(narrower_, x, y);
            numbers.narrow_towards(narrower);
        }
        is_done_[i] = 1;
        field_.cells[i] = field_cell(numbers, sigma_, step_, points_);
    }

    GaussianField& field_;
    const TorusMap& own_;
    double sigma_, step_, points_;
    std::vector<std::uint8_t> is_done_; ///< bytes, which threads can write side by side
    BlurredDensity narrower_;
};

}

float gaussian_exponent(double squared_sigma)
{
    return static_cast<float>(-0.5 * std::numbers::log2e / squared_sigma * 0x1p-64);
}

std::size_t GaussianFieldShape::cells() const
{
    return listed > 0 ? std::size_t{listed} * FIELD_CELLS * FIELD_CELLS : std::size_t{size} * size;
}

const GaussianField::Cell& GaussianField::cell(int column, int row) const
{
    const auto x = static_cast<std::uint32_t>(column), y = static_cast<std::uint32_t>(row);
    if (shape.listed == 0) return cells[std::size_t{y} * shape.size + x];
    static constexpr Cell nothing{0, 0, 0, 0, 1};
    const std::size_t number = listed.number_of(y / FIELD_CELLS, x / FIELD_CELLS);
    if (number == listed.row_starts[y / FIELD_CELLS + 1] || listed.columns[number] != x / FIELD_CELLS) return nothing;
    return cells[(number * FIELD_CELLS + y % FIELD_CELLS) * FIELD_CELLS + x % FIELD_CELLS];
}

GaussianNumbers between(const GaussianNumbers& low, const GaussianNumbers& high, double part)
{
    const auto of = [&](double a, double b) { return a * (1 - part) + b * part; };
    return {of(low.squared, high.squared), of(low.under, high.under), of(low.slope_x, high.slope_x),
            of(low.slope_y, high.slope_y)};
}

GaussianField::Cell field_cell(const GaussianNumbers& numbers, double sigma, double step, double points)
{
    const double squared = sigma * sigma * numbers.squared;
    const double pull = step * 2 * std::numbers::pi * numbers.squared * squared / points;
    return {.x = static_cast<float>(pull * numbers.slope_x),
            .y = static_cast<float>(pull * numbers.slope_y),
            .excess = static_cast<float>(2 * std::numbers::pi * sigma * sigma * (numbers.under - 1)),
            .exponent = gaussian_exponent(squared / points),
            .is_empty = 0};
}

std::uint32_t gaussian_grid(double sigma, std::size_t points, int dimension)
{
    const double side =
        dimension == 2 ? std::sqrt(static_cast<double>(points)) : std::cbrt(static_cast<double>(points));
    return static_cast<std::uint32_t>(3 * side / (gaussian_cut_off * sigma));
}

GaussianFieldShape gaussian_field_shape(const Density& density, double sigma, std::size_t points)
{
    const double side = std::sqrt(static_cast<double>(points));
    const double above_mean =
        static_cast<double>(static_cast<WideSum>(std::ranges::max(density.weights)) * density.weights.size()) /
        static_cast<double>(sum_of_weights(density));
    const auto width = [&](int number) { return sigma * root_power(number, 4) / side; };

    GaussianFieldShape shape;
    while (root_power(shape.narrowest, 2) * above_mean > 1 && width(shape.narrowest - 1) * most_field_size >= 2)
        --shape.narrowest;
    shape.size = least_field_size;
    while (shape.size * width(shape.narrowest) < 4 && shape.size < most_field_size) shape.size *= 2;
    shape.grid_size = gaussian_grid(sigma * root_power(shape.narrowest, 4), points, 2);
    while (gaussian_cut_off * width(shape.widest + 1) <= 0.5) ++shape.widest;
    return shape;
}

GaussianField gaussian_field(const Density& density, double sigma, double step, std::size_t points)
{
    GaussianField field{gaussian_field_shape(density, sigma, points), {}};
    const GaussianFieldShape& shape = field.shape;
    const double side = std::sqrt(static_cast<double>(points));
    field.cells.resize(std::size_t{shape.size} * shape.size);
    const auto width = [&](int number) { return sigma * root_power(number, 4) / side; };
    const TorusMap deviation = resampled(deviations(density), static_cast<std::size_t>(density.width), shape.size);
    WidthChooser chooser(field, deviation, sigma, step, points);
    BlurLadder ladder(deviation, width(shape.narrowest));
    for (int number = shape.narrowest; number <= shape.widest; ++number) {
        if (number > shape.narrowest) ladder.blur_to(width(number));
        chooser.choose(number, ladder.map(), number == shape.widest);
    }
    for (std::size_t i = 0; i < field.cells.size(); ++i) field.cells[i].is_empty = deviation.values[i] == -1 ? 1 : 0;
    return field;
}

}
