#include "tiles/sphere/polyomino_sphere.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace poissonlab {
namespace {

/// Spheres have these realizations of the streams of tori, of which there are fewer.
constexpr std::uint32_t first_sphere = std::uint32_t{1} << 31;

/// Tiles of all squares lie in one lattice: square i covers from period * i + margin on along x. A tile belongs to the
/// square that has its first cell, and its other cells are fewer than `margin` sides away.
constexpr std::int64_t lattice_period = 5, lattice_margin = 2;

/// A place of a square's own lattice, and the square.
struct SquarePlace
{
    std::uint32_t square = 0;
    LatticePlace place;
};

LatticePlace corner_of(std::uint32_t square, std::int64_t side)
{
    return {(lattice_period * square + lattice_margin) * side, 0};
}

SquarePlace in_square(const LatticePlace& place, std::int64_t side)
{
    const auto square = static_cast<std::uint32_t>(place.x / (lattice_period * side));
    return {square, place - corner_of(square, side)};
}

Pose scaled(const Pose& pose, std::int64_t side) { return {side * pose.shift, pose.turn}; }

/// The square that has a cell, where it does not depend on the way.
std::optional<SeenSquare> square_of_cell(std::uint32_t from, const LatticePlace& cell, std::int64_t side)
{
    const LatticePlace middle = 2 * cell + LatticePlace{1, 1};
    const SeenSquare seen = square_around(from, middle, 2 * side, true);
    if (seen != square_around(from, middle, 2 * side, false)) return std::nullopt;
    return seen;
}

std::size_t cell_index(std::uint32_t square, const LatticePlace& cell, std::int64_t side)
{
    return static_cast<std::size_t>((square * side + cell.y) * side + cell.x);
}

/// All places of tiles, by the square that has the first cell, in turns; those that lie around a vertex of three
/// squares on a way that is not the only one are left out.
std::vector<Pose> random_sphere_tiling(Polyomino shape, std::int64_t side, std::uint64_t seed,
                                       std::uint32_t realization)
{
    CoverProblem problem{.columns = static_cast<std::uint32_t>(healpix_squares * side * side),
                         .rows = {},
                         .steps = 20'000,
                         .searches = 1'000};
    std::vector<Pose> poses;
    const auto add = [&](std::uint32_t square, const Pose& pose) {
        std::vector<std::uint32_t> row;
        for (const LatticePlace& cell : cells_of(shape)) {
            const LatticePlace moved = moved_cell(pose, cell);
            const auto seen = square_of_cell(square, moved, side);
            if (!seen) return;
            row.push_back(static_cast<std::uint32_t>(
                cell_index(seen->square, moved_cell(scaled(seen->pose, side), moved), side)));
        }
        std::ranges::sort(row);
        if (std::ranges::adjacent_find(row) != row.end()) return;
        problem.rows.push_back(std::move(row));
        poses.push_back({pose.shift + corner_of(square, side), pose.turn});
    };
    for (std::uint32_t square = 0; square < healpix_squares; ++square)
        for (std::int64_t i = 0; i < side * side; ++i)
            for (Turn turn = 0; turn < turns; ++turn)
                add(square, {LatticePlace{i % side, i / side} - moved_cell({{}, turn}, cells_of(shape).front()), turn});
    const auto rows = exact_cover(problem, seed, Purpose::polyomino_seed, first_sphere + realization);
    if (!rows)
        throw InputError(fmt::format("no tiling of the sphere with {} polyominoes was found", polyominoes[shape]));
    std::vector<Pose> tiling;
    for (const std::uint32_t row : *rows) tiling.push_back(poses[row]);
    return tiling;
}

/// The class that has the most tiles of a collar, of those the first.
std::uint32_t nearest_class(const Neighbourhoods& all, const Collar& collar)
{
    const auto common = [&](const Collar& other) {
        return std::ranges::count_if(collar, [&](const Pose& pose) { return std::ranges::binary_search(other, pose); });
    };
    return static_cast<std::uint32_t>(std::ranges::max_element(all.collars, {}, common) - all.collars.begin());
}

}

PolyominoSphere::PolyominoSphere(const PolyominoTable& table, std::uint64_t seed, std::uint32_t realization)
    : PolyominoTiles(table, side_of(table.neighbourhoods.rule.shape), healpix_squares,
                     random_sphere_tiling(table.neighbourhoods.rule.shape, side_of(table.neighbourhoods.rule.shape),
                                          seed, realization)),
      first_side_(side_units(table.neighbourhoods.first_level) / cell_units)
{
    find_owners();
    classify();
    order_roots(seed, realization);
}

void PolyominoSphere::find_owners()
{
    owners_.resize(static_cast<std::size_t>(healpix_squares * first_side_ * first_side_));
    for (std::uint32_t tile = 0; tile < first_tiles().size(); ++tile)
        for (const LatticePlace& cell : cells_of(table().neighbourhoods.rule.shape)) {
            // The tile's shift may lie in another square than its cells: the first root decides, by the margin.
            const Pose& pose = first_tiles()[tile];
            const auto [square, moved] = in_square(moved_cell(pose, cell), first_side_);
            const SeenSquare seen = *square_of_cell(square, moved, first_side_);
            const Pose to_cell = scaled(seen.pose, first_side_);
            owners_[cell_index(seen.square, moved_cell(to_cell, moved), first_side_)] = {
                tile, composed(to_cell, {pose.shift - corner_of(square, first_side_), pose.turn})};
        }
}

Collar PolyominoSphere::collar_of(std::uint32_t tile) const
{
    Collar collar;
    const Pose& pose = first_tiles()[tile];
    for (const LatticePlace& cell : cells_of(table().neighbourhoods.rule.shape)) {
        const auto [home, moved] = in_square(moved_cell(pose, cell), first_side_);
        const SeenSquare own = *square_of_cell(home, moved, first_side_);
        const LatticePlace middle = moved_cell(scaled(own.pose, first_side_), moved);
        const CellOwner& itself = owners_[cell_index(own.square, middle, first_side_)];
        for (std::int64_t i = 0; i < 9; ++i) {
            const LatticePlace around = middle + LatticePlace{i % 3 - 1, i / 3 - 1};
            const auto seen = square_of_cell(own.square, around, first_side_);
            if (!seen) continue; // across a vertex of three squares
            const Pose to_cell = scaled(seen->pose, first_side_);
            const CellOwner& owner = owners_[cell_index(seen->square, moved_cell(to_cell, around), first_side_)];
            const Pose other = seen_from(itself.pose, composed(inverse(to_cell), owner.pose));
            if (other != Pose{} && std::ranges::find(collar, other) == collar.end()) collar.push_back(other);
        }
    }
    std::ranges::sort(collar);
    return collar;
}

void PolyominoSphere::classify()
{
    const Neighbourhoods& all = table().neighbourhoods;
    std::map<Collar, std::uint32_t> known;
    for (std::uint32_t i = 0; i < all.collars.size(); ++i) known.emplace(all.collars[i], i);
    for (std::uint32_t tile = 0; tile < first_tiles().size(); ++tile) {
        const Collar collar = collar_of(tile);
        const auto found = known.find(collar);
        if (found == known.end()) strange_.push_back(tile);
        classes_.push_back(found == known.end() ? nearest_class(all, collar) : found->second);
    }
}

/// Each root is the one farthest from those before, after a random first one: the points of the first roots, and those
/// of any part of a round over all roots, are spread over the sphere.
void PolyominoSphere::order_roots(std::uint64_t seed, std::uint32_t realization)
{
    const std::size_t roots = counts().roots, parts = first_tiles().size() / roots;
    std::vector<UnitVector> middles;
    for (std::size_t root = 0; root < roots; ++root) {
        UnitVector sum{};
        for (std::size_t i = 0; i < parts; ++i) {
            const LevelTile tile{first_tiles()[root * parts + i], 0, 0};
            const UnitVector middle =
                direction_of(sphere_place(this->middle(tile, table().neighbourhoods.first_level)));
            for (std::size_t k = 0; k < 3; ++k) sum[k] += middle[k];
        }
        const double length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        for (double& c : sum) c /= length;
        middles.push_back(sum);
    }
    const StreamKey key = stream_key(seed, Purpose::polyomino_seed, first_sphere + realization,
                                     std::numeric_limits<std::uint32_t>::max()); // no search comes so far
    std::vector<double> nearest(roots, -2); // cosines; more than 1: the root has its place
    auto next = static_cast<std::uint32_t>(philox({}, key)[0] % roots);
    while (order_.size() < roots) {
        order_.push_back(next);
        for (std::size_t root = 0; root < roots; ++root) {
            double cosine = 0;
            for (std::size_t k = 0; k < 3; ++k) cosine += middles[root][k] * middles[next][k];
            nearest[root] = std::max(nearest[root], root == next ? 2 : cosine);
        }
        next = static_cast<std::uint32_t>(std::ranges::min_element(nearest) - nearest.begin());
    }
}

HealpixPlace PolyominoSphere::on_sphere(const LatticePlace& units, std::uint32_t level) const
{
    const std::int64_t side = side_units(level);
    const auto [home, place] = in_square(units, side);
    const auto excess = [side](std::int64_t c) { return std::max(-c, c - side); };
    const SeenSquare seen = square_around(home, place, side, excess(place.x) >= excess(place.y));
    const LatticePlace inside = turned(seen.pose.turn, place) + side * seen.pose.shift;
    const auto part = [side](std::int64_t c) { return static_cast<double>(c) / static_cast<double>(side); };
    return {seen.square, part(inside.x), part(inside.y)};
}

std::uint32_t PolyominoSphere::first_tile_at(const HealpixPlace& place) const
{
    const auto cell = [&](double c) {
        return std::clamp<std::int64_t>(static_cast<std::int64_t>(c * static_cast<double>(first_side_)), 0,
                                        first_side_ - 1);
    };
    return owners_[cell_index(place.square, {cell(place.x), cell(place.y)}, first_side_)].tile;
}

std::vector<SpherePlace> polyomino_points(const PolyominoSphere& sphere, std::size_t points)
{
    const std::uint32_t level = sphere.counts().level_of(static_cast<double>(points));
    const std::uint32_t row = sphere.counts().row_of(static_cast<double>(points), level);
    std::vector<SpherePlace> set(points);
    tbb::parallel_for(std::size_t{0}, points, [&](std::size_t value) {
        set[value] = sphere_place(sphere.point(sphere.tile(value, level), level, row));
    });
    return set;
}

std::vector<SpherePlace> polyomino_points(const PolyominoSphere& sphere, std::uint64_t values,
                                          const std::function<double(const SpherePlace& place)>& wanted)
{
    const std::uint32_t finest = sphere.counts().level_of(static_cast<double>(values));
    const auto wanted_at = [&](const LevelTile& tile) { return wanted(sphere_place(sphere.middle(tile, finest))); };
    std::vector<std::optional<SpherePlace>> places(values);
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t value) {
        if (const auto chosen = sphere.chosen_tile(value, finest, wanted_at))
            places[value] = sphere_place(sphere.point(chosen->tile, chosen->level, chosen->row));
    });
    std::vector<SpherePlace> set;
    for (const auto& place : places)
        if (place) set.push_back(*place);
    return set;
}

}
