#include "base/regions/fixed_space.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/solid_lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint32_t most_position = (1u << FixedSpace::coordinate_bits) - 1;
constexpr std::uint32_t lattice_cell = 1u << FixedSpace::lattice_shift;

/// Places along each axis of cells that the border of a solid's box cuts, by which their volume is known.
constexpr std::uint32_t volume_places = 8;

/// A position's place between the eight corners of its cell, in positions.
using InCell = std::array<std::int64_t, 3>;

/// The value there, times the side of a cell: linear between the corners that one comes to along the axis of the
/// largest coordinate, then along that of the second and the third.
std::int64_t value_in_cell(const std::array<std::int64_t, 8>& corners, const InCell& at)
{
    std::size_t first = 0, last = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (at[k] > at[first]) first = k;
        if (at[k] <= at[last]) last = k;
    }
    const std::size_t middle = 3 - first - last;
    const std::size_t one = std::size_t{1} << first, two = one | std::size_t{1} << middle;
    return corners[0] * (lattice_cell - at[first]) + corners[one] * (at[first] - at[middle]) +
           corners[two] * (at[middle] - at[last]) + corners[7] * at[last];
}

/// The side of the positions of a box in a cell. Along an axis values grow as along one of the cell's four edges.
RegionSide side_in_cell(const std::array<std::int64_t, 8>& corners, const InCell& low, const InCell& extent)
{
    const auto [least, most] = std::ranges::minmax(corners);
    if (most <= 0) return RegionSide::outside;
    if (least > 0) return RegionSide::inside;
    std::int64_t lowest = value_in_cell(corners, low), highest = lowest;
    for (std::size_t k = 0; k < 3; ++k) {
        std::int64_t fall = 0, rise = 0;
        for (std::size_t corner = 0; corner < 8; ++corner) {
            if (corner >> k & 1) continue;
            const std::int64_t slope = corners[corner | std::size_t{1} << k] - corners[corner];
            fall = std::min(fall, slope);
            rise = std::max(rise, slope);
        }
        lowest += fall * extent[k];
        highest += rise * extent[k];
    }
    if (highest <= 0) return RegionSide::outside;
    return lowest > 0 ? RegionSide::inside : RegionSide::crossed;
}

/// Twice the distance along an axis from the middle of a ball.
std::uint64_t twice_from_middle(std::uint32_t position)
{
    const std::int64_t twice = std::int64_t{2} * position - most_position;
    return static_cast<std::uint64_t>(std::abs(twice));
}

}

FixedSpace::FixedSpace(const SpaceRegion& region, double margin)
    : shape_(region.shape), box_(region.box), unit_(torus_side(region.box) * 0x1p-32)
{
    const double inset = margin * 0x1p32;
    volume_ = box_.extent(0) * box_.extent(1) * box_.extent(2);
    for (std::size_t k = 0; k < 3; ++k) {
        // No position lies beyond the box. Along the longest side, and all those of a ball, they end there.
        const bool is_longest = shape_ == SpaceShape::ball || box_.extent(k) == box_.longest();
        const double high = is_longest ? double{most_position} : std::floor(box_.extent(k) / unit_);
        extent_.high[k] = static_cast<std::uint32_t>(std::clamp(high, 0.0, double{most_position}));
    }
    limits_ = extent_;
    if (shape_ == SpaceShape::ball) {
        volume_ *= M_PI / 6;
        const double radius = std::floor(double{most_position} - 2 * inset);
        if (radius < 0) limits_ = {{1, 1, 1}, {0, 0, 0}};
        squared_radius_ =
            static_cast<std::uint64_t>(std::max(radius, 0.0)) * static_cast<std::uint64_t>(std::max(radius, 0.0));
        return;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = std::ceil(inset), high = std::floor(double{1} * extent_.high[k] - inset);
        limits_.low[k] = low > high ? 1 : static_cast<std::uint32_t>(low);
        limits_.high[k] = low > high ? 0 : static_cast<std::uint32_t>(high);
    }
    if (shape_ == SpaceShape::solid) set_lattice(region, inset);
}

void FixedSpace::set_lattice(const SpaceRegion& region, double margin)
{
    for (std::size_t k = 0; k < 3; ++k) cells_[k] = (extent_.high[k] >> lattice_shift) + 1;
    const double cell = unit_ * lattice_cell;
    SolidLattice solid = region.reading ? region.reading(box_.low, cell, cells_)
                                        : solid_of_formula(region.formula, box_.low, cell, cells_);
    values_ = solid.values;
    volume_ = volume_of_lattice();
    if (margin > 0)
        values_ =
            inset_solid(solid, margin / lattice_cell,
                        region.reading ? region.formula : fmt::format("formula \"{}\"", shortened(region.formula)))
                .values;
    count_filled();
    shrink_extent();
}

/// Shrinks the extent to the cells in which something is inside.
void FixedSpace::shrink_extent()
{
    if (filled_.back() == 0) return;
    Cell first = cells_, last{};
    for (std::uint32_t z = 0; z < cells_[2]; ++z)
        for (std::uint32_t y = 0; y < cells_[1]; ++y)
            for (std::uint32_t x = 0; x < cells_[0]; ++x) {
                if (std::ranges::max(corners_of({x, y, z})) <= 0) continue;
                const Cell cell{x, y, z};
                for (std::size_t k = 0; k < 3; ++k) {
                    first[k] = std::min(first[k], cell[k]);
                    last[k] = std::max(last[k], cell[k]);
                }
            }
    for (std::size_t k = 0; k < 3; ++k) {
        extent_.low[k] = std::max(extent_.low[k], first[k] << lattice_shift);
        extent_.high[k] = std::min(extent_.high[k], (last[k] << lattice_shift) + (lattice_cell - 1));
    }
}

double FixedSpace::volume_of_lattice() const
{
    double cells = 0;
    for (std::uint32_t z = 0; z < cells_[2]; ++z)
        for (std::uint32_t y = 0; y < cells_[1]; ++y)
            for (std::uint32_t x = 0; x < cells_[0]; ++x) {
                const Cell cell{x, y, z};
                const auto corners = corners_of(cell);
                bool is_whole = true;
                for (std::size_t k = 0; k < 3; ++k)
                    is_whole &= (std::uint64_t{cell[k]} + 1) << lattice_shift <= std::uint64_t{extent_.high[k]} + 1;
                if (is_whole) {
                    cells += part_inside(corners);
                    continue;
                }
                int inside = 0;
                constexpr std::uint32_t step = lattice_cell / volume_places;
                for (std::uint32_t i = 0; i < volume_places * volume_places * volume_places; ++i) {
                    TorusPoint<3> place;
                    InCell at;
                    for (std::size_t k = 0, rest = i; k < 3; ++k, rest /= volume_places) {
                        at[k] = static_cast<std::int64_t>(rest % volume_places) * step + step / 2;
                        place[k] = (cell[k] << lattice_shift) + static_cast<std::uint32_t>(at[k]);
                    }
                    inside += place[0] <= extent_.high[0] && place[1] <= extent_.high[1] &&
                              place[2] <= extent_.high[2] && value_in_cell(corners, at) > 0;
                }
                cells += inside / double{volume_places * volume_places * volume_places};
            }
    return cells * std::pow(unit_ * lattice_cell, 3);
}

std::array<std::int64_t, 8> FixedSpace::corners_of(const Cell& cell) const
{
    std::array<std::int64_t, 8> corners{};
    for (std::uint32_t c = 0; c < 8; ++c)
        corners[c] = values_[node({cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2)})];
    return corners;
}

void FixedSpace::count_filled()
{
    filled_.assign(values_.size(), 0);
    for (std::uint32_t z = 0; z < cells_[2]; ++z)
        for (std::uint32_t y = 0; y < cells_[1]; ++y) {
            std::uint32_t row = 0;
            for (std::uint32_t x = 0; x < cells_[0]; ++x) {
                row += std::ranges::max(corners_of({x, y, z})) > 0;
                filled_[node({x + 1, y + 1, z + 1})] = row + filled_[node({x + 1, y, z + 1})] +
                                                       filled_[node({x + 1, y + 1, z})] - filled_[node({x + 1, y, z})];
            }
        }
}

bool FixedSpace::is_within_limits(const TorusPoint<3>& p) const
{
    bool is_within = true;
    for (std::size_t k = 0; k < 3; ++k) is_within &= limits_.low[k] <= p[k] && p[k] <= limits_.high[k];
    return is_within;
}

bool FixedSpace::contains(const TorusPoint<3>& p) const
{
    if (!is_within_limits(p)) return false;
    if (shape_ == SpaceShape::box) return true;
    if (shape_ == SpaceShape::ball) {
        std::uint64_t squared = 0;
        for (const std::uint32_t c : p) squared += twice_from_middle(c) * twice_from_middle(c);
        return squared <= squared_radius_;
    }
    InCell at;
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) {
        cell[k] = p[k] >> lattice_shift;
        at[k] = p[k] & (lattice_cell - 1);
    }
    return value_in_cell(corners_of(cell), at) > 0;
}

RegionSide FixedSpace::side_of(const FixedSpaceBox& box) const
{
    FixedSpaceBox cut;
    for (std::size_t k = 0; k < 3; ++k) {
        cut.low[k] = std::max(box.low[k], limits_.low[k]);
        cut.high[k] = std::min(box.high[k], limits_.high[k]);
        if (cut.low[k] > cut.high[k]) return RegionSide::outside;
    }
    RegionSide side = RegionSide::inside;
    if (shape_ == SpaceShape::ball) side = side_of_ball(cut);
    if (shape_ == SpaceShape::solid) side = side_of_solid(cut);
    const bool is_cut = cut.low != box.low || cut.high != box.high;
    return is_cut && side == RegionSide::inside ? RegionSide::crossed : side;
}

RegionSide FixedSpace::side_of_ball(const FixedSpaceBox& box) const
{
    std::uint64_t nearest = 0, farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t low = twice_from_middle(box.low[k]), high = twice_from_middle(box.high[k]);
        const bool has_middle = box.low[k] <= most_position / 2 && box.high[k] > most_position / 2;
        const std::uint64_t near = has_middle ? 1 : std::min(low, high), far = std::max(low, high);
        nearest += near * near;
        farthest += far * far;
    }
    if (nearest > squared_radius_) return RegionSide::outside;
    return farthest <= squared_radius_ ? RegionSide::inside : RegionSide::crossed;
}

RegionSide FixedSpace::side_of_solid(const FixedSpaceBox& box) const
{
    Cell first, last;
    bool is_large = false;
    for (std::size_t k = 0; k < 3; ++k) {
        first[k] = box.low[k] >> lattice_shift;
        last[k] = box.high[k] >> lattice_shift;
        is_large |= last[k] > first[k] + 1;
    }
    const auto below = [&](std::uint32_t z) {
        return filled_[node({last[0] + 1, last[1] + 1, z})] - filled_[node({first[0], last[1] + 1, z})] -
               filled_[node({last[0] + 1, first[1], z})] + filled_[node({first[0], first[1], z})];
    };
    if (below(last[2] + 1) == below(first[2])) return RegionSide::outside;
    if (is_large) return RegionSide::crossed;
    bool has_inside = false, has_outside = false;
    for (std::uint32_t z = first[2]; z <= last[2]; ++z)
        for (std::uint32_t y = first[1]; y <= last[1]; ++y)
            for (std::uint32_t x = first[0]; x <= last[0]; ++x) {
                const Cell cell{x, y, z};
                InCell low, extent;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::int64_t begin = std::int64_t{cell[k]} << lattice_shift;
                    low[k] = std::max<std::int64_t>(box.low[k] - begin, 0);
                    extent[k] = std::min<std::int64_t>(box.high[k] - begin, lattice_cell - 1) - low[k];
                }
                const RegionSide side = side_in_cell(corners_of(cell), low, extent);
                if (side == RegionSide::crossed) return side;
                (side == RegionSide::inside ? has_inside : has_outside) = true;
            }
    if (has_inside && has_outside) return RegionSide::crossed;
    return has_inside ? RegionSide::inside : RegionSide::outside;
}

std::array<double, 3> FixedSpace::own(const TorusPoint<3>& position) const
{
    return {box_.low[0] + unit_ * position[0], box_.low[1] + unit_ * position[1], box_.low[2] + unit_ * position[2]};
}

}
