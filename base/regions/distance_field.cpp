#include "base/regions/distance_field.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_shares.hpp"
#include "base/regions/region_squares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace poissonlab {
namespace {

/// A region is long if it meets fewer than this part of the cells of a square grid of `most_squares` cells. Its
/// distances are then read on at most as many smaller squares that cover it.
constexpr double part_of_long = 1.0 / 64;
constexpr std::size_t most_squares = std::size_t{1} << 18;

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
        lay_cells(DistanceTable::box_shift);
        find_shares();
        const auto cells = std::ranges::count_if(table_.share, [](double share) { return share > 0; });
        if (static_cast<double>(cells) < part_of_long * static_cast<double>(most_squares)) cover_with_squares();
    }

    DistanceTable read()
    {
        read_places();
        raise_nodes();
        measure();
        return std::move(table_);
    }

private:
    void lay_cells(std::uint32_t shift)
    {
        table_.shift = shift;
        table_.columns = (region_.extent().high[0] >> shift) + 1;
        table_.rows = (region_.extent().high[1] >> shift) + 1;
        width_ = 2 * table_.columns + 1;
        cell_side_ = 1u << shift;
    }

    void cover_with_squares()
    {
        const RegionSquares<FixedRegion> squares =
            small_squares_of(region_, most_squares, static_cast<int>(DistanceTable::least_shift));
        if (squares.corners.empty() || squares.shift >= static_cast<int>(DistanceTable::box_shift)) return;
        lay_cells(static_cast<std::uint32_t>(squares.shift));
        for (const TorusPoint<2>& corner : squares.corners)
            table_.squares.push_back({corner[0] >> table_.shift, corner[1] >> table_.shift});
        std::ranges::sort(table_.squares, {}, [](const auto& square) { return std::pair(square[1], square[0]); });
        find_shares();
    }

    bool has_squares() const { return !table_.squares.empty(); }

    std::size_t cells() const { return has_squares() ? table_.squares.size() : cell_at(0, table_.rows); }

    std::size_t cell_at(std::uint32_t column, std::uint32_t row) const
    {
        return std::size_t{row} * table_.columns + column;
    }

    /// The column and the row of a cell.
    std::array<std::uint32_t, 2> place_of(std::size_t cell) const
    {
        if (has_squares()) return table_.squares[cell];
        return {static_cast<std::uint32_t>(cell % table_.columns), static_cast<std::uint32_t>(cell / table_.columns)};
    }

    /// Calls visit(column, row) for all cells that have a part in the region.
    template <typename Visit>
    void for_each_cell(const Visit& visit) const
    {
        for (std::size_t cell = 0; cell < cells(); ++cell)
            if (table_.share[cell] > 0) visit(place_of(cell)[0], place_of(cell)[1]);
    }

    void find_shares()
    {
        const ShareLattice lattice{{}, double{1} * cell_side_, table_.columns, table_.rows};
        table_.share =
            has_squares() ? region_shares(region_, lattice, table_.squares) : region_shares(region_, lattice);
        for (std::size_t cell = 0; cell < cells(); ++cell) {
            const auto [column, row] = place_of(cell);
            const TorusPoint<2> low{column * cell_side_, row * cell_side_};
            const RegionSide side = region_.side_of({low, {low[0] + cell_side_ - 1, low[1] + cell_side_ - 1}});
            double& share = table_.share[cell];
            if (side == RegionSide::outside)
                share = 0;
            else
                share = std::max(
                    share * part_left_by_margins(region_, {double{1} * low[0], double{1} * low[1]}, cell_side_),
                    least_share);
        }
    }

    /// The number of a place. Places are twice as dense as nodes: those of the whole box, row by row, or those of the
    /// squares.
    std::size_t place_number(std::uint32_t x, std::uint32_t y) const
    {
        if (!has_squares()) return std::size_t{y} * width_ + x;
        const auto found = std::ranges::lower_bound(listed_, std::uint64_t{y} << 32 | x);
        return static_cast<std::size_t>(found - listed_.begin());
    }
    double place(std::uint32_t x, std::uint32_t y) const { return places_[place_number(x, y)]; }

    void list_places()
    {
        for (const auto& [column, row] : table_.squares)
            for (std::uint32_t y = 2 * row; y < 2 * row + 3; ++y)
                for (std::uint32_t x = 2 * column; x < 2 * column + 3; ++x)
                    listed_.push_back(std::uint64_t{y} << 32 | x);
        std::ranges::sort(listed_);
        listed_.erase(std::ranges::unique(listed_).begin(), listed_.end());
    }

    /// Beyond the region distances may be anything, and no number where they are nothing.
    void read_places()
    {
        const auto read = [&](std::uint32_t x, std::uint32_t y) {
            double value = distance_(place_along(x, 0), place_along(y, 1));
            if (!is_distance(value)) value = distance_(within_box(x, 0), within_box(y, 1));
            places_.push_back(is_distance(value) ? value : std::numeric_limits<double>::quiet_NaN());
        };
        if (has_squares()) {
            list_places();
            for (const std::uint64_t at : listed_)
                read(static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at >> 32));
        } else
            for (std::uint32_t y = 0; y <= 2 * table_.rows; ++y)
                for (std::uint32_t x = 0; x < width_; ++x) read(x, y);
        for_each_cell([&](std::uint32_t column, std::uint32_t row) {
            for (std::uint32_t y = 2 * row; y < 2 * row + 3; ++y)
                for (std::uint32_t x = 2 * column; x < 2 * column + 3; ++x) check_place(x, y);
        });
    }

    static bool is_distance(double value) { return value > 0 && !std::isinf(value); }

    /// A coordinate in units of the region: up to a cell beyond its box, so that interpolation is right at the border.
    double place_along(std::uint32_t half, std::size_t k) const
    {
        return region_.box().low[k] + region_.unit() * half * (cell_side_ / 2.0);
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
        const double low = region_.box().low[k], grain = region_.unit() * (cell_side_ / 64.0);
        return low + std::nearbyint((at - low) / grain) * grain;
    }

    void raise_nodes()
    {
        std::vector<double> lacks(places_.size()); // of nodes alone
        for_each_cell([&](std::uint32_t column, std::uint32_t row) {
            const double lack = lack_of(2 * column, 2 * row);
            for (const std::uint32_t y : {2 * row, 2 * row + 2})
                for (const std::uint32_t x : {2 * column, 2 * column + 2}) {
                    double& most = lacks[place_number(x, y)];
                    most = std::max(most, lack);
                }
        });
        const auto add_node = [&](std::uint32_t column, std::uint32_t row) {
            const std::size_t at = place_number(2 * column, 2 * row);
            table_.nodes.push_back(places_[at] + raised * lacks[at]);
        };
        for (const auto& [column, row] : table_.squares)
            for (std::uint32_t corner = 0; corner < 4; ++corner) add_node(column + corner % 2, row + corner / 2);
        if (has_squares()) return;
        for (std::uint32_t row = 0; row <= table_.rows; ++row)
            for (std::uint32_t column = 0; column <= table_.columns; ++column) add_node(column, row);
    }

    /// Returns how far bilinear interpolation falls below the distance, in the middle of a cell or of a side.
    double lack_of(std::uint32_t x, std::uint32_t y) const
    {
        const double a = place(x, y), b = place(x + 2, y), c = place(x, y + 2), d = place(x + 2, y + 2);
        return std::max({0.0, place(x + 1, y) - (a + b) / 2, place(x + 1, y + 2) - (c + d) / 2,
                         place(x, y + 1) - (a + c) / 2, place(x + 2, y + 1) - (b + d) / 2,
                         place(x + 1, y + 1) - (a + b + c + d) / 4});
    }

    /// The slope of a bilinear function is largest in a corner of its cell.
    void measure()
    {
        table_.least = std::numeric_limits<double>::infinity();
        if (has_squares()) table_.slope_of_box = std::numeric_limits<double>::infinity();
        for (std::size_t cell = 0; cell < cells(); ++cell) {
            const auto [column, row] = place_of(cell);
            const std::size_t at = has_squares() ? 4 * cell : std::size_t{row} * (table_.columns + 1) + column;
            const std::size_t above = at + (has_squares() ? 2 : table_.columns + 1);
            measure_cell(cell, table_.nodes[at], table_.nodes[at + 1], table_.nodes[above], table_.nodes[above + 1]);
        }
        for (double& node : table_.nodes)
            if (std::isnan(node)) node = table_.least;
    }

    void measure_cell(std::size_t cell, double a, double b, double c, double d)
    {
        const double side = region_.unit() * cell_side_;
        const double slope =
            std::hypot(std::max(std::abs(b - a), std::abs(d - c)), std::max(std::abs(c - a), std::abs(d - b))) / side;
        table_.slope_of_box =
            std::isnan(a + b + c + d) ? std::numeric_limits<double>::infinity() : std::max(table_.slope_of_box, slope);
        const double share = table_.share[cell];
        if (share == 0) return;
        if (slope > table_.slope) {
            table_.slope = slope;
            const auto [column, row] = place_of(cell);
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
    std::uint32_t width_ = 0, cell_side_ = 0;
    std::vector<std::uint64_t> listed_; ///< places of squares, in rising order of y << 32 | x
    std::vector<double> places_;
};

}

DistanceTable distance_table(const FixedRegion& region, const DistanceAt& distance, const std::string& name)
{
    return TableReader(region, distance, name).read();
}

/// Interpolation rounds twice, by less than a position each time.
DistanceField::DistanceField(const DistanceTable& table, const FixedRegion& region, double scale)
    : columns_(table.squares.empty() ? table.columns : 0), rows_(table.rows), shift_(table.shift)
{
    constexpr double lost = 2;
    for (const double node : table.nodes) {
        const double distance = node * scale;
        const double exact = (distance + distance_rounding(distance, region.box())) / region.unit() + lost;
        nodes_.push_back(static_cast<std::uint32_t>(std::min(std::ceil(exact), 0x1p31 - 1)));
    }
    if (columns_ == 0)
        bound_squares(table);
    else
        bound_cells();
}

void DistanceField::bound_cells()
{
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

void DistanceField::bound_squares(const DistanceTable& table)
{
    std::map<std::uint32_t, std::uint32_t> least; // of places
    for (std::size_t i = 0; i < table.squares.size(); ++i)
        least[table.squares[i][1] << 16 | table.squares[i][0]] =
            std::min({nodes_[4 * i], nodes_[4 * i + 1], nodes_[4 * i + 2], nodes_[4 * i + 3]});
    const std::uint32_t levels = FixedRegion::coordinate_bits - shift_ + 1;
    bounds_.resize(levels + 1);
    for (std::uint32_t level = 0; level < levels; ++level) {
        bounds_[level] = static_cast<std::uint32_t>(bounds_.size());
        for (const auto& square : least) bounds_.push_back(square.first);
        for (const auto& square : least) bounds_.push_back(square.second);
        std::map<std::uint32_t, std::uint32_t> wider;
        for (const auto& [place, distance] : least) {
            const auto [at, is_new] = wider.try_emplace(place >> 17 << 16 | (place & 0xFFFF) >> 1, distance);
            if (!is_new) at->second = std::min(at->second, distance);
        }
        least = std::move(wider);
    }
    bounds_[levels] = static_cast<std::uint32_t>(bounds_.size());
}

/// The number of the square with a position among those of 2^(shift + level) positions, or how many these are.
std::uint32_t DistanceField::number_of_square(const TorusPoint<2>& position, std::uint32_t level) const
{
    const std::uint32_t size = shift_ + level, count = (bounds_[level + 1] - bounds_[level]) / 2;
    const std::uint32_t place = position[1] >> size << 16 | position[0] >> size;
    const auto places = std::span(bounds_).subspan(bounds_[level], count);
    const auto found = std::ranges::lower_bound(places, place);
    return found != places.end() && *found == place ? static_cast<std::uint32_t>(found - places.begin()) : count;
}

/// Interpolates as distance_at() of kernels/common/darts/distance_field.clh does, bit by bit. Positions beyond the
/// table have the distance of its border, those beyond squares the least one.
std::uint32_t DistanceField::at(const TorusPoint<2>& position) const
{
    const bool has_squares = columns_ == 0;
    const std::uint32_t side = 1u << shift_;
    std::uint32_t column = position[0] >> shift_, row = position[1] >> shift_;
    std::size_t at = 0;
    if (has_squares) {
        at = 4 * std::size_t{number_of_square(position, 0)};
        if (at == nodes_.size()) return least();
    } else {
        column = std::min(column, columns_ - 1);
        row = std::min(row, rows_ - 1);
        at = std::size_t{row} * (columns_ + 1) + column;
    }
    const std::size_t next_row = at + (has_squares ? 2 : columns_ + 1);
    const std::int64_t x = std::min(position[0] - column * side, side), y = std::min(position[1] - row * side, side);
    const auto between = [this](std::int64_t from, std::int64_t to, std::int64_t part) {
        return from + ((to - from) * part >> shift_);
    };
    const std::int64_t below = between(nodes_[at], nodes_[at + 1], x);
    const std::int64_t above = between(nodes_[next_row], nodes_[next_row + 1], x);
    return static_cast<std::uint32_t>(between(below, above, y));
}

std::uint32_t DistanceField::least_in(const TorusPoint<2>& low, std::uint32_t bits) const
{
    if (bits >= shift_ && columns_ == 0) {
        const std::uint32_t level = std::min<std::uint32_t>(bits, FixedRegion::coordinate_bits) - shift_;
        const std::uint32_t number = number_of_square(low, level), count = (bounds_[level + 1] - bounds_[level]) / 2;
        return number == count ? least() : bounds_[bounds_[level] + count + number];
    }
    if (bits >= shift_) {
        std::size_t begin = 0, columns = columns_, rows = rows_;
        std::uint32_t level = shift_;
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
