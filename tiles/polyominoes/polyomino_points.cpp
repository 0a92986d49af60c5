#include "tiles/polyominoes/polyomino_points.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/permutation_hash.hpp"

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

/// Points of the torus for a weight of 1.
double points_per_weight(std::size_t points, const Density& density)
{
    double sum = 0;
    for (const std::uint64_t weight : density.weights) sum += static_cast<double>(weight);
    return static_cast<double>(points) * static_cast<double>(density.weights.size()) / sum;
}

}

PolyominoCounts::PolyominoCounts(Polyomino shape, std::uint32_t side, std::uint32_t squares)
    : roots(std::uint64_t{squares} * side * side / cells_of(shape).size()),
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

PolyominoTiles::PolyominoTiles(const PolyominoTable& table, std::uint32_t side, std::uint32_t squares,
                               const std::vector<Pose>& roots)
    : side_(side), table_(table), counts_(table.neighbourhoods.rule.shape, side, squares),
      anchor_(anchor_of(table.neighbourhoods.rule.shape)),
      tiles_(divided(table.neighbourhoods.rule, roots, table.neighbourhoods.first_level))
{}

LevelTile PolyominoTiles::tile(std::uint64_t value, std::uint32_t level) const
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

LatticePlace PolyominoTiles::point_units(const LevelTile& tile, std::uint32_t row) const
{
    return point_of(tile.pose, anchor_, table_.correction(row, tile.tile_class, tile.number));
}

std::int64_t PolyominoTiles::side_units(std::uint32_t level) const
{
    const auto factor = static_cast<std::uint64_t>(table_.neighbourhoods.rule.factor);
    return static_cast<std::int64_t>(side_ * power(factor, level)) * cell_units;
}

std::optional<ChosenTile> PolyominoTiles::chosen_tile(std::uint64_t value, std::uint32_t finest,
                                                      const std::function<double(const LevelTile& tile)>& wanted) const
{
    const double points = wanted(tile(value, finest));
    if (static_cast<double>(value) >= points) return std::nullopt;
    const std::uint32_t level = counts_.level_of(points);
    return ChosenTile{tile(value, level), level, counts_.row_of(points, level)};
}

namespace {

std::vector<Pose> torus_roots(Polyomino shape, std::uint32_t side, std::uint64_t seed, std::uint32_t realization)
{
    std::vector<Pose> roots = random_torus_tiling(shape, side, seed, realization);
    if (roots.empty()) throw InputError(fmt::format("no tiling of {} x {} cells was found", side, side));
    return roots;
}

}

PolyominoTorus::PolyominoTorus(const PolyominoTable& table, std::uint32_t side, std::uint64_t seed,
                               std::uint32_t realization)
    : PolyominoTiles(table, side, 1, torus_roots(table.neighbourhoods.rule.shape, side, seed, realization))
{
    const Neighbourhoods& all = table.neighbourhoods;
    order_ = random_permutation(static_cast<std::uint32_t>(counts().roots),
                                stream_key(seed, Purpose::polyomino_seed, realization, order_attempt), 0);
    const auto period = side_units(all.first_level) / cell_units;
    for (const Collar& collar : collars_on_torus(all.rule.shape, first_tiles(), period))
        classes_.push_back(class_of(all, collar));
}

std::array<double, 2> PolyominoTorus::on_torus(const LatticePlace& units, std::uint32_t level) const
{
    const std::int64_t side = side_units(level);
    const auto wrapped = [&](std::int64_t c) {
        return static_cast<double>((c % side + side) % side) / static_cast<double>(side);
    };
    return {wrapped(units.x), wrapped(units.y)};
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

double proven_distance(const PolyominoTiles& tiles, std::size_t points)
{
    const std::uint32_t level = tiles.counts().level_of(static_cast<double>(points));
    const RowProof& proof = tiles.table().proofs[tiles.counts().row_of(static_cast<double>(points), level) - 1];
    const auto squared = static_cast<double>(proof.squared_distance_after(level));
    return std::sqrt(squared) / static_cast<double>(tiles.side_units(level));
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
    const auto wanted = [&](const LevelTile& tile) {
        const auto [x, y] = torus.middle(tile, finest);
        return scale * static_cast<double>(density.at(x, y));
    };
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t value) {
        if (const auto chosen = torus.chosen_tile(value, finest, wanted))
            places[value] = torus.point(chosen->tile, chosen->level, chosen->row);
    });
    PointSet set{2, {}};
    for (const auto& place : places)
        if (place) set.coordinates.insert(set.coordinates.end(), place->begin(), place->end());
    return set;
}

}
