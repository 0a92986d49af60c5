#include "host/sampling/regions/region_field.hpp"

#include "base/errors/errors.hpp"
#include "host/sampling/optimized/torus_map.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace poissonlab {
namespace {

constexpr std::int64_t field_cells = contract::gaussian_blue_noise::FIELD_CELLS;

/// Cells of the field for the narrowest Gaussian's width. A cell of the grid is twice as wide as that, then, a little
/// more than a third of the cut-off.
constexpr double cells_of_width = 4;

/// Widths, each 2^(1/2) times the one before: the widest is 8 times as wide as the narrowest.
constexpr int width_count = 7;
constexpr double widest = 8;

/// The part of the points under a Gaussian that is enough.
constexpr double enough_under = 1.0 / 4;

/// These limit the number of listed cells. Strips a fifth of a mean distance wide have four listed cells a point. In
/// narrower strips, the narrowest Gaussians are wider, and so are the cells.
constexpr double listed_of_point = 4, listed_always = 1024;

/// A mean distance is looked for again where margins leave so little of it.
constexpr double well_known = 3.0 / 4;

/// The box of positions in a square; nothing where there are none.
std::optional<FixedBox> positions_in(double x, double y, double side)
{
    constexpr double last = 0x1p31 - 1;
    if (x + side < 0 || y + side < 0 || x > last || y > last) return {};
    const auto position = [&](double place) { return static_cast<std::uint32_t>(std::clamp(place, 0.0, last)); };
    return FixedBox{{position(x), position(y)}, {position(x + side), position(y + side)}};
}

}

RegionField::RegionField(const FixedRegion& region, std::size_t points, double sigma, const FieldSizeCheck& check)
    : region_(region), points_(static_cast<double>(points)), sigma_(sigma)
{
    const double wholly = std::sqrt(region.area() / points_) / region.unit();
    double mean = wholly, left = 0, without = HUGE_VAL; // the narrowest cells without room for a point
    while (left < well_known * mean) {
        if (left > 0) mean = left;
        narrowest_ = 1;
        while (!list_cells(narrowest_ * sigma * mean / cells_of_width)) narrowest_ *= 2;
        if (check && !check(shape())) return;
        const double sum = read_shares();
        if (sum == 0 && lattice_.side < without) {
            without = lattice_.side;
            left = mean / 2;
            continue;
        }
        if (sum == 0)
            throw InputError(fmt::format(
                "Gaussian blue noise knows a region by cells {:.2g} mean distances wide, and none of them has room for "
                "a point: too little is left by obstacles and the boundary",
                lattice_.side / wholly));
        left = std::sqrt(sum / points_) * lattice_.side;
        full_ = points_ * lattice_.columns * lattice_.columns / sum;
    }
}

GaussianFieldShape RegionField::shape() const
{
    return {.size = lattice_.columns,
            .grid_size = lattice_.columns / static_cast<std::uint32_t>(field_cells),
            .listed = static_cast<std::uint32_t>(listed_.columns.size())};
}

/// Lists the cells of the grid in which cells of the field are beside or in the region. Returns false if they are too
/// many.
bool RegionField::list_cells(double cell)
{
    const FixedBox& box = region_.extent();
    const double longest = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]) + 1.0;
    const double around = gaussian_cut_off * widest * cells_of_width / field_cells + 2;
    const auto size = static_cast<std::uint32_t>(longest / (cell * field_cells) + around);
    const auto fine = size * static_cast<std::uint32_t>(field_cells);
    lattice_ = {{box.low[0] - cell * field_cells, box.low[1] - cell * field_cells}, cell, fine, fine};
    std::vector<std::uint64_t> found;
    if (!add_cells(0, 0, std::bit_ceil(size), found)) return false;
    listed_ = cell_rows(std::move(found), size);
    return true;
}

/// Adds those in a square of the grid, which has `size` of them along each axis.
bool RegionField::add_cells(std::uint32_t column, std::uint32_t row, std::uint32_t size,
                            std::vector<std::uint64_t>& found) const
{
    const double wide = lattice_.side * field_cells;
    const auto low = [&](std::size_t k, std::uint32_t number) {
        return std::floor(lattice_.low[k] + number * wide - lattice_.side);
    };
    const auto box = positions_in(low(0, column), low(1, row), size * wide + 2 * lattice_.side + 2);
    if (!box || region_.side_of(*box) == RegionSide::outside) return true;
    if (size == 1) {
        if (found.size() == UINT32_MAX / cells_of_listed)
            throw InputError("Gaussian blue noise in a region has at most 2^32 cells, too few for so many points");
        found.push_back(std::uint64_t{row} << 32 | column);
        return static_cast<double>(found.size()) <= listed_of_point * points_ + listed_always;
    }
    const std::uint32_t half = size / 2;
    return add_cells(column, row, half, found) && add_cells(column + half, row, half, found) &&
           add_cells(column, row + half, half, found) && add_cells(column + half, row + half, half, found);
}

/// Reads what cells of the field have of the region, and returns the sum.
double RegionField::read_shares()
{
    std::vector<std::array<std::uint32_t, 2>> cells;
    std::vector<std::size_t> numbers; // of the cells in listed ones
    for (std::uint32_t row = 0; row < lattice_.rows; ++row) {
        const std::uint32_t grid_row = row / static_cast<std::uint32_t>(field_cells);
        for (std::size_t i = listed_.row_starts[grid_row]; i < listed_.row_starts[grid_row + 1]; ++i)
            for (std::uint32_t x = 0; x < field_cells; ++x) {
                cells.push_back({listed_.columns[i] * static_cast<std::uint32_t>(field_cells) + x, row});
                numbers.push_back((i * field_cells + row % field_cells) * field_cells + x);
            }
    }
    std::vector<double> shares = region_shares(region_, lattice_, cells);
    tbb::parallel_for(std::size_t{0}, cells.size(),
                      [&](std::size_t i) { shares[i] = left_by_margins(cells[i], shares[i]); });
    is_empty_.assign(cells.size(), 1);
    runs_.clear();
    rows_.clear();
    double sum = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (shares[i] == 0) continue;
        is_empty_[numbers[i]] = 0;
        sum += shares[i];
        const std::int64_t column = cells[i][0], row = cells[i][1];
        const bool begins = rows_.empty() || rows_.back().number != row;
        if (begins) rows_.push_back({row, runs_.size()});
        if (!begins && runs_.back().end == column && runs_.back().share == shares[i])
            ++runs_.back().end;
        else
            runs_.push_back({column, column + 1, shares[i]});
    }
    rows_.push_back({INT64_MAX, runs_.size()});
    return sum;
}

/// The part of a cell that is allowed, of which `share` lies in the region.
double RegionField::left_by_margins(const std::array<std::uint32_t, 2>& cell, double share) const
{
    const double x = std::floor(lattice_.low[0] + cell[0] * lattice_.side);
    const double y = std::floor(lattice_.low[1] + cell[1] * lattice_.side);
    const auto box = positions_in(x, y, lattice_.side);
    if (!box) return 0;
    const RegionSide side = region_.side_of(*box);
    if (side != RegionSide::crossed) return side == RegionSide::inside ? 1 : 0;
    return share * part_left_by_margins(region_, {double{1} * box->low[0], double{1} * box->low[1]}, lattice_.side);
}

std::vector<RegionField::Width> RegionField::widths() const
{
    const double cells = sigma_ * lattice_.columns / std::sqrt(full_);
    std::vector<Width> widths;
    for (int number = 0; number < width_count; ++number) {
        Width width;
        width.squared = narrowest_ * narrowest_ * std::exp2(number);
        const double squared = width.squared * cells * cells;
        const std::vector<double> taps = gaussian_taps(std::sqrt(squared));
        width.reach = static_cast<std::int64_t>(taps.size()) - 1;
        width.tap_sums = width.slope_sums = {0};
        for (std::int64_t k = -width.reach; k <= width.reach; ++k) {
            width.taps.push_back(taps[static_cast<std::size_t>(std::abs(k))]);
            width.slopes.push_back(static_cast<double>(k) / squared * width.taps.back());
            width.tap_sums.push_back(width.tap_sums.back() + width.taps.back());
            width.slope_sums.push_back(width.slope_sums.back() + width.slopes.back());
        }
        widths.push_back(std::move(width));
    }
    return widths;
}

/// The numbers of Gaussians of that width in the cells of a listed one, which begin at a column and row of the field.
RegionField::Numbers RegionField::numbers_for(std::int64_t column, std::int64_t row, const Width& width) const
{
    std::array<double, cells_of_listed> under{}, slope_x{}, slope_y{};
    const std::int64_t reach = width.reach;
    for (auto line = std::ranges::lower_bound(rows_, row - reach, {}, &Row::number);
         line->number < row + field_cells + reach; ++line) {
        std::array<double, field_cells> sums{}, slopes{};
        const auto end = runs_.begin() + static_cast<std::ptrdiff_t>((line + 1)->first);
        auto run = std::partition_point(runs_.begin() + static_cast<std::ptrdiff_t>(line->first), end,
                                        [&](const Run& r) { return r.end <= column - reach; });
        for (; run != end && run->begin < column + field_cells + reach; ++run)
            for (std::int64_t x = 0; x < field_cells; ++x) {
                const auto before = [&](std::int64_t place) {
                    return static_cast<std::size_t>(std::clamp(place - column - x, -reach, reach + 1) + reach);
                };
                const std::size_t from = before(run->begin), to = before(run->end), i = static_cast<std::size_t>(x);
                sums[i] += run->share * (width.tap_sums[to] - width.tap_sums[from]);
                slopes[i] += run->share * (width.slope_sums[to] - width.slope_sums[from]);
            }
        for (std::int64_t y = 0; y < field_cells; ++y) {
            const std::int64_t away = line->number - row - y;
            if (away < -reach || away > reach) continue;
            const double tap = width.taps[static_cast<std::size_t>(away + reach)];
            const double slope = width.slopes[static_cast<std::size_t>(away + reach)];
            const auto first = static_cast<std::size_t>(y * field_cells);
            for (std::size_t x = 0; x < field_cells; ++x) {
                under[first + x] += tap * sums[x];
                slope_x[first + x] += tap * slopes[x];
                slope_y[first + x] += slope * sums[x];
            }
        }
    }
    Numbers numbers;
    const double per_side = lattice_.columns;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = {width.squared, width.squared * under[i], per_side * slope_x[i], per_side * slope_y[i]};
    return numbers;
}

/// The numbers of the narrowest Gaussians with enough under them, or of the widest ones.
RegionField::Numbers RegionField::narrowest(std::int64_t column, std::int64_t row,
                                            const std::vector<Width>& widths) const
{
    Numbers chosen = numbers_for(column, row, widths.front());
    const auto has_enough = [](const GaussianNumbers& numbers) { return numbers.under >= enough_under; };
    Numbers narrower = chosen;
    for (std::size_t i = 1; i < widths.size() && !std::ranges::all_of(narrower, has_enough); ++i) {
        const Numbers numbers = numbers_for(column, row, widths[i]);
        for (std::size_t cell = 0; cell < numbers.size(); ++cell) {
            if (has_enough(narrower[cell])) continue;
            const double lacking = enough_under - narrower[cell].under;
            chosen[cell] = has_enough(numbers[cell]) ? between(narrower[cell], numbers[cell],
                                                               lacking / (numbers[cell].under - narrower[cell].under))
                                                     : numbers[cell];
        }
        narrower = numbers;
    }
    return chosen;
}

GaussianField RegionField::field(double step) const
{
    GaussianField field{shape(), std::vector<GaussianField::Cell>(is_empty_.size()), listed_};
    const std::vector<Width> all = widths();
    tbb::parallel_for(std::size_t{0}, listed_.columns.size(), [&](std::size_t i) {
        const auto row = std::ranges::upper_bound(listed_.row_starts, i) - listed_.row_starts.begin() - 1;
        const Numbers numbers = narrowest(listed_.columns[i] * field_cells, row * field_cells, all);
        for (std::size_t cell = i * cells_of_listed; cell < (i + 1) * cells_of_listed; ++cell) {
            field.cells[cell] = field_cell(numbers[cell % cells_of_listed], sigma_, step, full_);
            field.cells[cell].is_empty = is_empty_[cell];
        }
    });
    return field;
}

}
