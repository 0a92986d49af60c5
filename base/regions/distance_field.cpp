#include "base/regions/distance_field.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr std::uint32_t cell_side = 1u << DistanceTable::shift;

/// Cells that are crossed count, however little of them is inside.
constexpr double least_share = 1e-9;

/// Nodes are raised by this times what bilinear interpolation lacks in the middles of cells and of their sides.
constexpr double raised = 1.25;

/// Places where a field is asked for its distances: nodes, and middles between them.
class TableReader
{
public:
    TableReader(const FixedRegion& region, const DistanceAt& distance, const std::string& name)
        : region_(region), distance_(distance), name_(name)
    {
        table_.columns = (region.extent().high[0] >> DistanceTable::shift) + 1;
        table_.rows = (region.extent().high[1] >> DistanceTable::shift) + 1;
        width_ = 2 * table_.columns + 1;
        places_.reserve(std::size_t{width_} * (2 * table_.rows + 1));
    }

    DistanceTable read()
    {
        find_shares();
        read_places();
        raise_nodes();
        measure();
        return std::move(table_);
    }

private:
    std::size_t cell_at(std::uint32_t column, std::uint32_t row) const
    {
        return std::size_t{row} * table_.columns + column;
    }

    /// Calls visit(column, row) for all cells that have a part in the region.
    template <typename Visit>
    void for_each_cell(const Visit& visit) const
    {
        for (std::uint32_t row = 0; row < table_.rows; ++row)
            for (std::uint32_t column = 0; column < table_.columns; ++column)
                if (table_.share[cell_at(column, row)] > 0) visit(column, row);
    }

    void find_shares()
    {
        table_.share = region_shares(region_, {{}, cell_side, table_.columns, table_.rows});
        for (std::uint32_t row = 0; row < table_.rows; ++row)
            for (std::uint32_t column = 0; column < table_.columns; ++column) {
                const TorusPoint<2> low{column * cell_side, row * cell_side};
                const RegionSide side = region_.side_of({low, {low[0] + cell_side - 1, low[1] + cell_side - 1}});
                double& share = table_.share[cell_at(column, row)];
                if (side == RegionSide::outside)
                    share = 0;
                else
                    share = std::max(
                        share * part_left_by_margins(region_, {double{1} * low[0], double{1} * low[1]}, cell_side),
                        least_share);
            }
    }

    /// Places twice as near as nodes.
    double& place(std::uint32_t x, std::uint32_t y) { return places_[std::size_t{y} * width_ + x]; }

    /// Beyond the region distances may be anything, and no number where they are nothing.
    void read_places()
    {
        for (std::uint32_t y = 0; y <= 2 * table_.rows; ++y)
            for (std::uint32_t x = 0; x < width_; ++x) {
                double value = distance_(place_along(x, 0), place_along(y, 1));
                if (!is_distance(value)) value = distance_(within_box(x, 0), within_box(y, 1));
                places_.push_back(is_distance(value) ? value : std::numeric_limits<double>::quiet_NaN());
            }
        for_each_cell([&](std::uint32_t column, std::uint32_t row) {
            for (std::uint32_t y = 2 * row; y < 2 * row + 3; ++y)
                for (std::uint32_t x = 2 * column; x < 2 * column + 3; ++x) check_place(x, y);
        });
    }

    static bool is_distance(double value) { return value > 0 && !std::isinf(value); }

    /// A coordinate in units of the region: up to a cell beyond its box, so that interpolation is right at the border.
    double place_along(std::uint32_t half, std::size_t k) const
    {
        return region_.box().low[k] + region_.unit() * half * (cell_side / 2.0);
    }

    /// A coordinate, moved to just inside the region's extent, which is rounded to the grid: a formula may be no
    /// distance beyond it.
    double within_box(std::uint32_t half, std::size_t k) const
    {
        const double low = region_.own(region_.extent().low)[k] + region_.unit();
        const double high = region_.own(region_.extent().high)[k] - region_.unit();
        return std::clamp(place_along(half, k), std::min(low, high), std::max(low, high));
    }

    void check_place(std::uint32_t x, std::uint32_t y)
    {
        if (!std::isnan(place(x, y))) return;
        const double at_x = within_box(x, 0), at_y = within_box(y, 1);
        throw InputError(fmt::format("{} is {:.6g} at {:.6g}, {:.6g}, in or beside the region: must be above 0", name_,
                                     distance_(at_x, at_y), shown(at_x, 0), shown(at_y, 1)));
    }

    /// Places just inside are said to be at the border.
    double shown(double at, std::size_t k) const
    {
        const double low = region_.box().low[k], grain = region_.unit() * (cell_side / 64.0);
        return low + std::nearbyint((at - low) / grain) * grain;
    }

    void raise_nodes()
    {
        const std::size_t nodes = table_.columns + 1;
        std::vector<double> lacks(nodes * (table_.rows + 1));
        for_each_cell([&](std::uint32_t column, std::uint32_t row) {
            const double lack = lack_of(2 * column, 2 * row);
            for (const std::size_t at : {row * nodes + column, (row + 1) * nodes + column})
                for (const std::size_t i : {at, at + 1}) lacks[i] = std::max(lacks[i], lack);
        });
        for (std::uint32_t row = 0; row <= table_.rows; ++row)
            for (std::uint32_t column = 0; column <= table_.columns; ++column)
                table_.nodes.push_back(place(2 * column, 2 * row) + raised * lacks[row * nodes + column]);
    }

    /// Returns how far bilinear interpolation falls below the distance, in the middle of a cell or of a side.
    double lack_of(std::uint32_t x, std::uint32_t y)
    {
        const double a = place(x, y), b = place(x + 2, y), c = place(x, y + 2), d = place(x + 2, y + 2);
        return std::max({0.0, place(x + 1, y) - (a + b) / 2, place(x + 1, y + 2) - (c + d) / 2,
                         place(x, y + 1) - (a + c) / 2, place(x + 2, y + 1) - (b + d) / 2,
                         place(x + 1, y + 1) - (a + b + c + d) / 4});
    }

    /// The slope of a bilinear function is largest in a corner of its cell.
    void measure()
    {
        const double side = region_.unit() * cell_side;
        table_.least = std::numeric_limits<double>::infinity();
        for (std::uint32_t row = 0; row < table_.rows; ++row)
            for (std::uint32_t column = 0; column < table_.columns; ++column) {
                const std::size_t at = std::size_t{row} * (table_.columns + 1) + column;
                measure_cell(column, row, side, table_.nodes[at], table_.nodes[at + 1],
                             table_.nodes[at + table_.columns + 1], table_.nodes[at + table_.columns + 2]);
            }
        for (double& node : table_.nodes)
            if (std::isnan(node)) node = table_.least;
    }

    void measure_cell(std::uint32_t column, std::uint32_t row, double side, double a, double b, double c, double d)
    {
        const double slope =
            std::hypot(std::max(std::abs(b - a), std::abs(d - c)), std::max(std::abs(c - a), std::abs(d - b))) / side;
        table_.slope_of_box =
            std::isnan(a + b + c + d) ? std::numeric_limits<double>::infinity() : std::max(table_.slope_of_box, slope);
        const double share = table_.share[cell_at(column, row)];
        if (share == 0) return;
        if (slope > table_.slope) {
            table_.slope = slope;
            table_.steepest = {region_.box().low[0] + (column + 0.5) * side, region_.box().low[1] + (row + 0.5) * side};
        }
        table_.least = std::min({table_.least, a, b, c, d});
        table_.most = std::max({table_.most, a, b, c, d});
        const double middle = (a + b + c + d) / 4;
        table_.packing += share * side * side / (middle * middle);
    }

    const FixedRegion& region_;
    const DistanceAt& distance_;
    const std::string& name_;
    DistanceTable table_;
    std::uint32_t width_ = 0;
    std::vector<double> places_;
};

}

DistanceTable distance_table(const FixedRegion& region, const DistanceAt& distance, const std::string& name)
{
    return TableReader(region, distance, name).read();
}

/// Interpolation rounds twice, by less than a position each time.
DistanceField::DistanceField(const DistanceTable& table, const FixedRegion& region, double scale)
    : columns_(table.columns), rows_(table.rows)
{
    constexpr double lost = 2;
    for (const double node : table.nodes) {
        const double distance = node * scale;
        const double exact = (distance + distance_rounding(distance, region.box())) / region.unit() + lost;
        nodes_.push_back(static_cast<std::uint32_t>(std::min(std::ceil(exact), 0x1p31 - 1)));
    }
    const std::size_t stride = columns_ + 1;
    for (std::size_t row = 0; row < rows_; ++row)
        for (std::size_t column = 0; column < columns_; ++column) {
            const std::size_t at = row * stride + column;
            bounds_.push_back(std::min({nodes_[at], nodes_[at + 1], nodes_[at + stride], nodes_[at + stride + 1]}));
        }
    std::size_t begin = 0, columns = columns_, rows = rows_;
    while (columns > 1 || rows > 1) {
        const std::size_t next = bounds_.size(), half = (columns + 1) / 2;
        bounds_.resize(next + half * ((rows + 1) / 2), std::numeric_limits<std::uint32_t>::max());
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t column = 0; column < columns; ++column) {
                std::uint32_t& least = bounds_[next + row / 2 * half + column / 2];
                least = std::min(least, bounds_[begin + row * columns + column]);
            }
        begin = next;
        columns = half;
        rows = (rows + 1) / 2;
    }
}

/// Interpolates as distance_at() of kernels/common/darts/distance_field.clh does, bit by bit. Positions beyond the
/// table have the distance of its border.
std::uint32_t DistanceField::at(const TorusPoint<2>& position) const
{
    const std::uint32_t column = std::min(position[0] >> DistanceTable::shift, columns_ - 1);
    const std::uint32_t row = std::min(position[1] >> DistanceTable::shift, rows_ - 1);
    const std::int64_t x = std::min(position[0] - column * cell_side, cell_side);
    const std::int64_t y = std::min(position[1] - row * cell_side, cell_side);
    const std::size_t at = std::size_t{row} * (columns_ + 1) + column;
    const auto between = [](std::int64_t from, std::int64_t to, std::int64_t part) {
        return from + ((to - from) * part >> DistanceTable::shift);
    };
    const std::int64_t below = between(nodes_[at], nodes_[at + 1], x);
    const std::int64_t above = between(nodes_[at + columns_ + 1], nodes_[at + columns_ + 2], x);
    return static_cast<std::uint32_t>(between(below, above, y));
}

std::uint32_t DistanceField::least_in(const TorusPoint<2>& low, std::uint32_t bits) const
{
    if (bits >= DistanceTable::shift) {
        std::size_t begin = 0, columns = columns_, rows = rows_;
        std::uint32_t level = DistanceTable::shift;
        for (; level < bits && (columns > 1 || rows > 1); ++level) {
            begin += columns * rows;
            columns = (columns + 1) / 2;
            rows = (rows + 1) / 2;
        }
        const std::size_t column = std::min<std::size_t>(low[0] >> level, columns - 1);
        const std::size_t row = std::min<std::size_t>(low[1] >> level, rows - 1);
        return bounds_[begin + row * columns + column];
    }
    const std::uint32_t last = (1u << bits) - 1;
    const std::uint32_t least = std::min(
        {at(low), at({low[0] + last, low[1]}), at({low[0], low[1] + last}), at({low[0] + last, low[1] + last})});
    return bits == 0 ? least : least - 1; // rounded values between corners may be one lower
}

}
