#include "tiles/polyominoes/polyomino_points.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/random_permutation.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// The attempt of the stream that orders roots: no search for a tiling comes so far.
constexpr std::uint32_t order_attempt = std::numeric_limits<std::uint32_t>::max();

std::uint64_t power(std::uint64_t base, std::uint32_t exponent)
{
    std::uint64_t result = 1;
    for (; exponent > 0; --exponent) result *= base;
    return result;
}

/// The point of a value, if it has one. The density at its tile on the finest level decides, so that none is missing
/// among points of that level; the point is that of the tile on the level that the density there asks for.
std::optional<std::array<double, 2>> point_of_value(const PolyominoTorus& torus, std::uint64_t value, double scale,
                                                    const Density& density, std::uint32_t finest)
{
    const auto [x, y] = torus.middle(torus.tile(value, finest), finest);
    const double wanted = scale * static_cast<double>(density.at(x, y));
    if (static_cast<double>(value) >= wanted) return std::nullopt;
    const std::uint32_t level = torus.counts().level_of(wanted);
    return torus.point(torus.tile(value, level), level, torus.counts().row_of(wanted, level));
}

/// Points of the torus for a weight of 1.
double points_per_weight(std::size_t points, const Density& density)
{
    double sum = 0;
    for (const std::uint64_t weight : density.weights) sum += static_cast<double>(weight);
    return static_cast<double>(points) * static_cast<double>(density.weights.size()) / sum;
}

}

PolyominoCounts::PolyominoCounts(Polyomino shape, std::uint32_t side)
    : roots(std::uint64_t{side} * side / cells_of(shape).size()),
      children(power(static_cast<std::uint64_t>(factor_of(shape)), 2)),
      least_level(first_level_of(shape) + table_depth_of(shape)),
      last_row(static_cast<std::uint32_t>(power(children, table_depth_of(shape))))
{}

std::uint64_t PolyominoCounts::tiles(std::uint32_t level) const { return roots * power(children, level); }

std::uint32_t PolyominoCounts::level_of(double points) const
{
    std::uint32_t level = least_level;
    while (static_cast<double>(tiles(level)) < points) ++level;
    return level;
}

std::uint32_t PolyominoCounts::row_of(double points, std::uint32_t level) const
{
    const double part = points / static_cast<double>(tiles(level));
    return std::clamp(static_cast<std::uint32_t>(std::ceil(part * last_row)), 1U, last_row);
}

PolyominoTorus::PolyominoTorus(const PolyominoTable& table, std::uint32_t side, std::uint64_t seed,
                               std::uint32_t realization)
    : table_(table), side_(side), counts_(table.neighbourhoods.rule.shape, side),
      anchor_(anchor_of(table.neighbourhoods.rule.shape))
{
    const Neighbourhoods& all = table.neighbourhoods;
    const std::vector<Pose> roots = random_torus_tiling(all.rule.shape, side, seed, realization);
    if (roots.empty()) throw InputError(fmt::format("no tiling of {} x {} cells was found", side, side));
    order_ = random_permutation(static_cast<std::uint32_t>(roots.size()),
                                stream_key(seed, Purpose::polyomino_seed, realization, order_attempt), 0);
    tiles_ = divided(all.rule, roots, all.first_level);
    const auto factor = static_cast<std::uint64_t>(all.rule.factor);
    const auto period = static_cast<std::int64_t>(side * power(factor, all.first_level));
    for (const Collar& collar : collars_on_torus(all.rule.shape, tiles_, period))
        classes_.push_back(class_of(all, collar));
}

LevelTile PolyominoTorus::tile(std::uint64_t value, std::uint32_t level) const
{
    const Neighbourhoods& all = table_.neighbourhoods;
    const std::uint64_t children = all.rule.children.size();
    std::uint64_t index = order_[value % counts_.roots], code = value / counts_.roots;
    std::uint32_t done = 0;
    for (; done < all.first_level; ++done, code /= children) index = index * children + code % children;
    LevelTile tile{tiles_[index], classes_[index], 0};
    for (; done < level - table_.depth; ++done, code /= children) {
        tile.pose = all.rule.child(tile.pose, code % children);
        tile.tile_class = all.child_class(tile.tile_class, code % children);
    }
    tile.number = code;
    for (; done < level; ++done, code /= children) tile.pose = all.rule.child(tile.pose, code % children);
    return tile;
}

std::int64_t PolyominoTorus::side_units(std::uint32_t level) const
{
    const auto factor = static_cast<std::uint64_t>(table_.neighbourhoods.rule.factor);
    return static_cast<std::int64_t>(side_ * power(factor, level)) * cell_units;
}

std::array<double, 2> PolyominoTorus::on_torus(const LatticePlace& units, std::uint32_t level) const
{
    const std::int64_t side = side_units(level);
    const auto wrapped = [&](std::int64_t c) {
        return static_cast<double>((c % side + side) % side) / static_cast<double>(side);
    };
    return {wrapped(units.x), wrapped(units.y)};
}

std::array<double, 2> PolyominoTorus::point(const LevelTile& tile, std::uint32_t level, std::uint32_t row) const
{
    return on_torus(point_of(tile.pose, anchor_, table_.correction(row, tile.tile_class, tile.number)), level);
}

std::array<double, 2> PolyominoTorus::middle(const LevelTile& tile, std::uint32_t level) const
{
    return on_torus(point_of(tile.pose, anchor_, {}), level);
}

PointSet polyomino_points(const PolyominoTorus& torus, std::size_t points)
{
    const std::uint32_t level = torus.counts().level_of(static_cast<double>(points));
    const std::uint32_t row = torus.counts().row_of(static_cast<double>(points), level);
    PointSet set{2, std::vector<double>(2 * points)};
    tbb::parallel_for(std::size_t{0}, points, [&](std::size_t value) {
        const auto [x, y] = torus.point(torus.tile(value, level), level, row);
        set.coordinates[2 * value] = x;
        set.coordinates[2 * value + 1] = y;
    });
    return set;
}

double proven_distance(const PolyominoTorus& torus, std::size_t points)
{
    const std::uint32_t level = torus.counts().level_of(static_cast<double>(points));
    const RowProof& proof = torus.table().proofs[torus.counts().row_of(static_cast<double>(points), level) - 1];
    const auto squared = static_cast<double>(proof.squared_distance_after(level));
    return std::sqrt(squared) / static_cast<double>(torus.side_units(level));
}

double polyomino_values(std::size_t points, const Density& density)
{
    return std::ceil(points_per_weight(points, density) * static_cast<double>(full_weight));
}

PointSet polyomino_points(const PolyominoTorus& torus, std::size_t points, const Density& density)
{
    const double scale = points_per_weight(points, density), values = polyomino_values(points, density);
    const std::uint32_t finest = torus.counts().level_of(values);
    std::vector<std::optional<std::array<double, 2>>> places(static_cast<std::size_t>(values));
    tbb::parallel_for(std::size_t{0}, places.size(),
                      [&](std::size_t value) { places[value] = point_of_value(torus, value, scale, density, finest); });
    PointSet set{2, {}};
    for (const auto& place : places)
        if (place) set.coordinates.insert(set.coordinates.end(), place->begin(), place->end());
    return set;
}

}
