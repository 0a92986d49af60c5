// Points of a Penrose tiling that is divided as a density asks for.
//
// Ostromoukhov, Donohue and Jodoin, Fast hierarchical importance sampling with blue noise properties, SIGGRAPH 2004.
// The importance of a place is the number of code values that have a point there; points stay whose value is below it.
// A triangle is divided while points that it would get can stay: the density is bounded over all of the triangle, and a
// triangle is left out where none of its points can come into the window. (The authors' program looks at corners and
// centre only, and leaves two corners of the square empty: dissertation, figure 6.16.)
#pragma once

#include "base/densities/density_bounds.hpp"
#include "base/geometry/point_set.hpp"
#include "host/device/device_memory.hpp"
#include "host/sampling/device_method.hpp"
#include "host/tile_sampling/penrose/penrose_table.hpp"
#include "kernels/common/tile_sampling/penrose.h"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

// The levels of a Penrose tiling in fixed-point numbers.

using PenroseScale = contract::penrose::Scale;
using PenroseScales = std::array<PenroseScale, contract::penrose::SCALES>;

/// A place in multiples of 2^-56 of the unit square's side.
using FixedPlace = std::array<std::int64_t, 2>;

/// The first corner of the root, a fat triangle whose first side has 2 phi^2 sides of the square: the square is in its
/// middle. (-(phi^2 - 1/2), -1/4), that of the authors' program.
inline constexpr FixedPlace penrose_root{static_cast<std::int64_t>(-2.118033988749895 * 0x1p56),
                                         static_cast<std::int64_t>(-0.25 * 0x1p56)};

/// The largest importance that has a level.
std::uint64_t most_penrose_importance();

/// All levels. Places are multiples of 2^-56 of the unit square's side, right within 2^-44: products and sums of
/// doubles make them, which every machine rounds alike.
PenroseScales penrose_scales(const PenroseTable& table);

/// The level of a root with a triangle of 2 sides that covers the unit square, and the row of a table, for an
/// importance from 1 to most_penrose_importance().
struct PenroseRow
{
    std::size_t level;
    std::size_t row;

    bool operator==(const PenroseRow&) const = default;
};
PenroseRow row_of_importance(const PenroseScales& scales, std::uint64_t importance);

/// The first importance of a row, and the one after its last. Rows of the first levels may be empty.
struct ImportanceRange
{
    std::uint64_t begin;
    std::uint64_t end;
};
ImportanceRange importances_of(const PenroseScales& scales, const PenroseRow& row);

/// Points per unit of importance in the unit square, on average: half of the values below an importance belong to
/// points of the root.
inline constexpr double points_per_importance = 0.4998 / 4.979797;

/// A square of the unit square, in units of 2^-32: x and y from low on.
struct PenroseWindow
{
    std::array<std::uint32_t, 2> low{};
    std::uint64_t side = std::uint64_t{1} << 32;
};

/// A point in units of 2^-32, and its value.
struct PenrosePoint
{
    std::array<std::uint32_t, 2> place{};
    std::uint64_t value = 0;

    bool operator==(const PenrosePoint&) const = default;
};

/// A triangle of the tiling as kernels have it, and points that lie beside such triangles.
struct PenroseStart
{
    std::vector<contract::penrose::Tile> triangles;
    std::vector<PenrosePoint> points;
};

/// A tiling with its levels, the table that moves its points, and a density, which lies over the unit square and goes
/// on outside as it is at the border.
struct PenroseTiling
{
    explicit PenroseTiling(const PenroseTable& table_, DensityBounds density_ = {})
        : table(table_), scales(penrose_scales(table_)), density(std::move(density_))
    {}

    PenroseTable table;
    PenroseScales scales;
    DensityBounds density;
};

/// Triangles that share the work, and the points that were met on the way to them.
PenroseStart start_penrose(const PenroseTiling& tiling, std::uint64_t importance, const PenroseWindow& window);

namespace reference {
/// The points with a value below the importance of their place, which is `importance` where the density has full
/// weight, at most most_penrose_importance(). In the order of the subdivision.
std::vector<PenrosePoint> penrose_points(const PenroseTiling& tiling, std::uint64_t importance,
                                         const PenroseWindow& window = {});
}

/// Points of the unit square.
PointSet point_set_of(const std::vector<PenrosePoint>& points);

/// Makes the points of the reference by kernels/penrose.cl, in the order of the reference.
class PenroseGenerator : DeviceMethod<struct PenroseBuffers>
{
public:
    /// `tiling` outlives this. `work_group_size` 0: the default.
    PenroseGenerator(Device device, const PenroseTiling& tiling, std::size_t work_group_size = 0);

    PointSet points(std::uint64_t importance, const PenroseWindow& window = {});

    /// The memory that sets of so many points take, with a density that has so many weights and bounds.
    static DeviceMemory memory(std::size_t points, std::size_t weights);

private:
    const PenroseTiling* tiling_;
};

}
