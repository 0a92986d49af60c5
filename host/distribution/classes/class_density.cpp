#include "host/distribution/classes/class_density.hpp"

#include "base/regions/region_shares.hpp"
#include "host/sampling/classes/class_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

/// Cells of this level are a 512th of the longest side wide, because regions lie in a quarter of the torus.
constexpr std::uint32_t least_level = 10, most_level = 24;

/// Parts of a density that the measured error refers to: 2^4.
constexpr std::uint32_t error_bits = 4;

OpenCells fine_cells(const FixedRegion& region, std::size_t least_cells)
{
    OpenCells cells = cells_in_region(region, least_level);
    while (cells.count(2) > 0 && cells.count(2) < least_cells && cells.level < most_level)
        cells = cells_in_region(region, cells.level + 1);
    return cells;
}

/// Returns the part of each cell that lies in the region.
std::vector<double> shares_of(const FixedRegion& region, const OpenCells& cells)
{
    const auto square = [&](std::size_t i) { return std::array{cells.cells[2 * i], cells.cells[2 * i + 1]}; };
    std::vector<std::size_t> order(cells.count(2));
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(square(i)[1], square(i)[0]); });
    std::vector<std::array<std::uint32_t, 2>> squares;
    for (const std::size_t i : order) squares.push_back(square(i));
    const double side = std::ldexp(1, 32 - static_cast<int>(cells.level));
    const std::uint32_t across = 1u << (cells.level - 1);
    const std::vector<double> sorted = region_shares(region, {{}, side, across, across}, squares);
    std::vector<double> shares(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const TorusPoint<2> low{squares[k][0] << (32 - cells.level), squares[k][1] << (32 - cells.level)};
        const auto extent = static_cast<std::uint32_t>(side) - 1;
        // Margins are looked at in few cells, as that takes many places of each.
        const bool is_inside = region.side_of({low, {low[0] + extent, low[1] + extent}}) == RegionSide::inside;
        shares[order[k]] =
            is_inside ? 1 : sorted[k] * part_left_by_margins(region, {double{1} * low[0], double{1} * low[1]}, side);
    }
    return shares;
}

/// Returns the mean of four places of a cell. Beyond the region, values that are none count as 0.
double mean_in(const FixedRegion& region, const DensityAt& density, const std::string& name, const std::uint32_t* cell,
               std::uint32_t level)
{
    double sum = 0;
    for (std::uint32_t place = 0; place < 4; ++place) {
        TorusPoint<2> at;
        for (std::uint32_t k = 0; k < 2; ++k)
            at[k] = (cell[k] << (32 - level)) + ((1 + 2 * (place >> k & 1)) << (30 - level));
        const auto [x, y] = region.own(at);
        const double value = density(x, y);
        if (value >= 0 && std::isfinite(value))
            sum += value / 4;
        else if (region.contains(at))
            throw DensityError(
                fmt::format("{}: is {:.6g} at {:.6g}, {:.6g} in the region: must be a finite number of at least 0",
                            name, std::isnan(value) ? NAN : value, x, y));
    }
    return sum;
}

/// Spreads bits, so that there is one between any two of them.
std::uint64_t spread_bits(std::uint64_t x)
{
    for (const auto& [shift, mask] : {std::pair{16, 0x0000FFFF0000FFFFull}, std::pair{8, 0x00FF00FF00FF00FFull},
                                      std::pair{4, 0x0F0F0F0F0F0F0F0Full}, std::pair{2, 0x3333333333333333ull},
                                      std::pair{1, 0x5555555555555555ull}})
        x = (x | x << shift) & mask;
    return x;
}

/// The place of a cell in the order of all cells of its level.
std::uint64_t morton(std::uint32_t x, std::uint32_t y) { return spread_bits(x) | spread_bits(y) << 1; }

}

RegionCells density_cells(const FixedRegion& region, std::size_t least)
{
    OpenCells cells = fine_cells(region, least);
    std::vector<double> shares = shares_of(region, cells);
    return {std::move(cells), std::move(shares)};
}

ClassDensity class_density(const FixedRegion& region, const RegionCells& cells, const DensityAt& density,
                           const std::string& name)
{
    const auto& [all, shares] = cells;
    std::vector<double> means;
    double most = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        means.push_back(mean_in(region, density, name, &all.cells[2 * i], all.level));
        if (shares[i] > 0) most = std::max(most, means[i]);
    }
    if (!(most > 0)) throw DensityError(fmt::format("{}: is 0 everywhere in the region, or nearly", name));
    // Masses near 1 neither overflow nor vanish where cells are divided.
    const int exponent = std::ilogb(most);
    ClassDensity made{{all.level, {}}, 1};
    double sum = 0, area = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double part = std::scalbn(means[i], -exponent) * shares[i];
        area += shares[i];
        if (!(part > 0)) continue;
        made.cells.cells.insert(made.cells.cells.end(), &all.cells[2 * i], &all.cells[2 * i] + 2);
        made.cells.masses.push_back(part);
        sum += part;
    }
    find_starts(made.cells);
    made.fullness = sum / (area * std::scalbn(most, -exponent));
    return made;
}

double density_error(const OpenCells& density, const PointSet& points)
{
    std::vector<std::uint64_t> cells;
    for (std::size_t i = 0; i < density.count(2); ++i)
        cells.push_back(morton(density.cells[2 * i], density.cells[2 * i + 1]));
    std::array<double, 1 << error_bits> counts{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto along = [&](std::size_t k) {
            return static_cast<std::uint32_t>(points[i][k] * 0x1p32) >> (32 - density.level);
        };
        const auto after = std::ranges::upper_bound(cells, morton(along(0), along(1)));
        const std::size_t cell = after == cells.begin() ? 0 : static_cast<std::size_t>(after - cells.begin()) - 1;
        ++counts[density.starts[cell] >> (32 - error_bits)];
    }
    double largest = 0;
    for (const double count : counts)
        largest = std::max(
            largest, std::abs(count / static_cast<double>(points.size()) - 1.0 / static_cast<double>(counts.size())));
    return points.size() > 0 ? largest : 0;
}

}
