#include "host/sampling/classics/torus_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace poissonlab {

std::uint64_t squared_torus_distance(const TorusPosition& a, const TorusPosition& b)
{
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t difference = static_cast<std::int32_t>(a[k] - b[k]); // the shorter way round
        sum += static_cast<std::uint64_t>(difference * difference);
    }
    return sum;
}

TorusGrid::TorusGrid(std::size_t points, int dimension) : dimension_(dimension)
{
    const std::size_t most = std::max<std::size_t>(points, 1);
    while (std::size_t{1} << (static_cast<std::size_t>((bits_ + 1) * dimension)) <= most) ++bits_;
    heads_.assign(std::size_t{1} << (bits_ * dimension), none);
    lasts_.assign(heads_.size(), {{}, empty});
}

std::size_t TorusGrid::cell_number(const std::array<std::int64_t, 3>& cell) const
{
    const std::int64_t mask = (std::int64_t{1} << bits_) - 1;
    std::size_t number = 0;
    for (int k = dimension_; k-- > 0;)
        number = number << bits_ | static_cast<std::size_t>(cell[static_cast<std::size_t>(k)] & mask);
    return number;
}

std::array<std::int64_t, 3> TorusGrid::cell_of(const TorusPosition& position) const
{
    std::array<std::int64_t, 3> cell{};
    for (std::size_t k = 0; k < 3; ++k) cell[k] = static_cast<std::int64_t>(std::uint64_t{position[k]} >> (32 - bits_));
    return cell;
}

void TorusGrid::add(const TorusPosition& position)
{
    const std::size_t cell = cell_number(cell_of(position));
    points_.push_back({position, heads_[cell]});
    lasts_[cell] = points_.back();
    heads_[cell] = static_cast<std::uint32_t>(points_.size() - 1);
}

void TorusGrid::ask_for_cells(const TorusPosition& position) const
{
    const auto home = cell_of(position);
    for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t x = -1; x <= 1; x += 2)
            __builtin_prefetch(&lasts_[cell_number({home[0] + x, home[1] + y, home[2]})]);
}

void TorusGrid::ask_for_points(const TorusPosition& position) const
{
    const auto home = cell_of(position);
    for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t x = -1; x <= 1; ++x) {
            const std::uint32_t next = lasts_[cell_number({home[0] + x, home[1] + y, home[2]})].next;
            if (next < empty) __builtin_prefetch(&points_[next]);
        }
}

void TorusGrid::visit(const std::array<std::int64_t, 3>& cell, const TorusPosition& position,
                      std::uint64_t& nearest) const
{
    const Link& last = lasts_[cell_number(cell)];
    if (last.next == empty) return;
    nearest = std::min(nearest, squared_torus_distance(last.position, position));
    for (std::uint32_t i = last.next; i != none; i = points_[i].next)
        nearest = std::min(nearest, squared_torus_distance(points_[i].position, position));
}

/// Looks at rings of cells around that of the position until none farther out can have a nearer point.
std::uint64_t TorusGrid::squared_nearest(const TorusPosition& position, std::uint64_t enough) const
{
    const std::int64_t side = std::int64_t{1} << (32 - bits_);
    std::array<std::int64_t, 3> home{};
    std::int64_t border = side; // distance from the border of the cell
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
        home[k] = std::int64_t{position[k]} / side;
        const std::int64_t inside = std::int64_t{position[k]} % side;
        border = std::min({border, inside, side - 1 - inside});
    }
    std::uint64_t nearest = UINT64_MAX;
    const std::int64_t most = std::int64_t{1} << bits_; // then all cells were visited
    for (std::int64_t ring = 0; 2 * ring - 1 < most; ++ring) {
        const auto away = static_cast<std::uint64_t>(std::max<std::int64_t>(0, border + (ring - 1) * side));
        if (ring > 0 && away < std::uint64_t{1} << 32 && away * away >= nearest) break;
        const std::int64_t layers = dimension_ == 3 ? ring : 0;
        for (std::int64_t z = -layers; z <= layers; ++z)
            for (std::int64_t y = -ring; y <= ring; ++y) {
                const bool is_outer = std::abs(y) == ring || (dimension_ == 3 && std::abs(z) == ring);
                for (std::int64_t x = -ring; x <= ring; x += is_outer || ring == 0 ? 1 : 2 * ring)
                    visit({home[0] + x, home[1] + y, home[2] + z}, position, nearest);
            }
        if (nearest <= enough) break;
    }
    return nearest;
}

std::vector<std::size_t> TorusGrid::within(const TorusPosition& position, double distance) const
{
    const std::int64_t side = std::int64_t{1} << (32 - bits_), most = std::int64_t{1} << bits_;
    const auto reach = static_cast<std::int64_t>(std::ceil(distance));
    std::array<std::int64_t, 3> first{}, count{1, 1, 1};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k) {
        first[k] = (std::int64_t{position[k]} - reach) >> (32 - bits_); // rounded down, also below 0
        count[k] = std::min(most, (std::int64_t{position[k]} + reach) / side - first[k] + 1);
    }
    std::vector<std::size_t> found;
    for (std::int64_t z = 0; z < count[2]; ++z)
        for (std::int64_t y = 0; y < count[1]; ++y)
            for (std::int64_t x = 0; x < count[0]; ++x)
                for (std::uint32_t i = heads_[cell_number({first[0] + x, first[1] + y, first[2] + z})]; i != none;
                     i = points_[i].next)
                    if (static_cast<double>(squared_torus_distance(points_[i].position, position)) <
                        distance * distance)
                        found.push_back(i);
    return found;
}

PointSet TorusGrid::point_set() const
{
    PointSet set{dimension_, {}};
    set.coordinates.reserve(points_.size() * static_cast<std::size_t>(dimension_));
    for (const Link& point : points_)
        for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_); ++k)
            set.coordinates.push_back(static_cast<double>(point.position[k]) / 4294967296.0);
    return set;
}

}
