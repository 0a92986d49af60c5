#include "host/tile_construction/tile_ranking.hpp"

#include "base/random/random.hpp"
#include "tiles/poisson/random_neighbours.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>

namespace poissonlab {
namespace {

/// Random neighbourhoods of each tile: with four, prefixes have a sixth more power at low frequencies; sixteen take
/// twice the time for a twentieth less.
constexpr std::uint32_t neighbourhoods = 8;

/// Tiles of a batch do not see what the others of it take.
constexpr std::uint32_t batches = 8;

/// The standard deviation of the Gaussians, and where they end, in mean distances of the points taken so far.
constexpr double influence_deviation = 0.5;
constexpr double influence_reach = 1.5;

/// Coordinates are coarser here, so that squared distances of points three tiles away have 31 bits.
constexpr int coarse_bits = 3;
constexpr std::int32_t coarse_side = tile_units >> coarse_bits;

using CoarsePosition = std::array<std::int32_t, 3>;

/// The Gaussian at a rank, as integers, whose sums do not depend on their order.
class Influence
{
public:
    Influence(std::uint32_t rank, int dimension)
    {
        const double spacing = coarse_side / std::pow(rank + 1.0, 1.0 / dimension);
        // The influence ends with the neighbouring tiles: nothing is known beyond.
        radius_ = std::min(coarse_side, static_cast<std::int32_t>(std::ceil(influence_reach * spacing)));
        const auto squared = static_cast<std::uint32_t>(radius_ * radius_);
        shift_ = std::max<int>(0, static_cast<int>(std::bit_width(squared)) - table_bits);
        for (std::size_t i = 0; i < table_.size(); ++i) {
            const double at =
                static_cast<double>(i << shift_) / (2 * influence_deviation * influence_deviation * spacing * spacing);
            table_[i] = static_cast<std::uint32_t>(std::lround(std::exp(-at) * (1 << 20)));
        }
    }

    std::int32_t radius() const { return radius_; }

    std::uint32_t of(std::int32_t squared_distance) const
    {
        return squared_distance < radius_ * radius_ ? table_[static_cast<std::size_t>(squared_distance >> shift_)] : 0;
    }

private:
    static constexpr int table_bits = 12;
    std::int32_t radius_ = 0;
    int shift_ = 0;
    std::array<std::uint32_t, 1 << table_bits> table_{};
};

/// A range of cells along each axis, both ends included.
struct CellRange
{
    CoarsePosition first{}, last{};
};

/// The points of each tile that have a rank, in cells, so that those near a place are found.
class TakenPoints
{
public:
    TakenPoints(const std::vector<CoarsePosition>& points, std::uint32_t tiles, std::uint32_t points_per_tile,
                int dimension)
        : points_(points), n_(points_per_tile), dimension_(static_cast<std::size_t>(dimension)), taken_(tiles),
          next_(points.size()), low_(points.front()), high_(points.front())
    {
        for (const CoarsePosition& point : points)
            for (std::size_t k = 0; k < 3; ++k) {
                low_[k] = std::min(low_[k], point[k]);
                high_[k] = std::max(high_[k], point[k]);
            }
        arrange(coarse_side);
    }

    /// New cells where others suit disks of this radius better: with a side of the radius to twice that.
    void suit(std::int32_t radius)
    {
        std::int32_t cell = coarse_side;
        while (cell / 2 >= radius) cell /= 2;
        if (cell != cell_) arrange(cell);
    }

    void take(std::uint32_t tile, std::uint32_t point)
    {
        taken_[tile].push_back(point);
        put(tile, point);
    }

    /// The cells within a radius of a place relative to a tile. None: no tile has points there.
    std::optional<CellRange> cells_near(const CoarsePosition& place, std::int32_t radius) const
    {
        CellRange range;
        for (std::size_t k = 0; k < dimension_; ++k) {
            const std::int32_t low = std::max(low_[k], place[k] - radius);
            const std::int32_t high = std::min(high_[k], place[k] + radius);
            if (low > high) return std::nullopt;
            range.first[k] = (low - low_[k]) / cell_;
            range.last[k] = (high - low_[k]) / cell_;
        }
        return range;
    }

    /// The influence at a place of a tile's points in these cells.
    std::uint64_t energy(std::uint32_t tile, const CellRange& cells, const CoarsePosition& place,
                         const Influence& influence) const
    {
        std::uint64_t sum = 0;
        for (std::int32_t z = cells.first[2]; z <= cells.last[2]; ++z)
            for (std::int32_t y = cells.first[1]; y <= cells.last[1]; ++y)
                for (std::int32_t x = cells.first[0]; x <= cells.last[0]; ++x)
                    for (std::uint32_t i = heads_[cell_number(tile, {x, y, z})]; i != none; i = next_[i]) {
                        const CoarsePosition& p = points_[i];
                        const std::int32_t dx = p[0] - place[0], dy = p[1] - place[1], dz = p[2] - place[2];
                        sum += influence.of(dx * dx + dy * dy + dz * dz);
                    }
        return sum;
    }

private:
    static constexpr std::uint32_t none = UINT32_MAX;

    void arrange(std::int32_t cell)
    {
        cell_ = cell;
        std::size_t cells = taken_.size();
        for (std::size_t k = 0; k < dimension_; ++k) {
            along_axis_[k] = (high_[k] - low_[k]) / cell + 1;
            cells *= static_cast<std::size_t>(along_axis_[k]);
        }
        heads_.assign(cells, none);
        for (std::uint32_t tile = 0; tile < taken_.size(); ++tile)
            for (const std::uint32_t point : taken_[tile]) put(tile, point);
    }

    void put(std::uint32_t tile, std::uint32_t point)
    {
        const std::uint32_t i = tile * n_ + point;
        CoarsePosition cell{};
        for (std::size_t k = 0; k < dimension_; ++k) cell[k] = (points_[i][k] - low_[k]) / cell_;
        std::uint32_t& head = heads_[cell_number(tile, cell)];
        next_[i] = head;
        head = i;
    }

    std::size_t cell_number(std::uint32_t tile, const CoarsePosition& cell) const
    {
        std::size_t number = tile;
        for (std::size_t k = dimension_; k-- > 0;)
            number = number * static_cast<std::size_t>(along_axis_[k]) + static_cast<std::size_t>(cell[k]);
        return number;
    }

    const std::vector<CoarsePosition>& points_;
    std::uint32_t n_;
    std::size_t dimension_;
    std::int32_t cell_ = 0;
    std::vector<std::vector<std::uint32_t>> taken_; ///< by tile
    std::vector<std::uint32_t> heads_, next_;       ///< points of a cell are a list
    CoarsePosition low_, high_;                     ///< of all points, relative to their tiles
    CoarsePosition along_axis_{};                   ///< cells of a tile
};

class Ranking
{
public:
    explicit Ranking(const PoissonTileSet& set)
        : p_(set.parameters), stream_(stream_key(p_.seed, Purpose::tile_ranking, 0)), points_(positions_of(set)),
          taken_(points_, p_.tiles, p_.points_per_tile, p_.dimension), ranks_(points_.size(), unranked)
    {}

    std::vector<std::uint16_t> run(const std::function<void(std::size_t done, std::size_t total)>& progress)
    {
        for (std::uint32_t rank = 0; rank < p_.points_per_tile; ++rank) {
            const Influence influence(rank, p_.dimension);
            taken_.suit(influence.radius());
            std::array<std::vector<std::uint32_t>, batches> parts;
            for (std::uint32_t tile = 0; tile < p_.tiles; ++tile)
                parts[philox({tile, rank, 0, order_use}, stream_)[0] % batches].push_back(tile);
            for (const auto& tiles : parts) rank_batch(tiles, rank, influence);
            if (progress) progress(rank + 1, p_.points_per_tile);
        }
        return std::move(ranks_);
    }

private:
    static constexpr std::uint16_t unranked = UINT16_MAX;

    /// Uses of random numbers; random_neighbours() has 0.
    static constexpr std::uint32_t order_use = 1, tie_use = 2;

    static std::vector<CoarsePosition> positions_of(const PoissonTileSet& set)
    {
        const PoissonTileParameters& p = set.parameters;
        std::vector<CoarsePosition> positions;
        for (std::uint32_t tile = 0; tile < p.tiles; ++tile)
            for (std::uint32_t point = 0; point < p.points_per_tile; ++point) {
                CoarsePosition position = set.position(tile, point);
                for (std::int32_t& x : position) x >>= coarse_bits;
                positions.push_back(position);
            }
        return positions;
    }

    void rank_batch(const std::vector<std::uint32_t>& tiles, std::uint32_t rank, const Influence& influence)
    {
        std::vector<std::uint32_t> chosen(tiles.size());
        tbb::parallel_for(std::size_t{0}, tiles.size(),
                          [&](std::size_t i) { chosen[i] = loneliest_point(tiles[i], rank, influence); });
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            ranks_[std::size_t{tiles[i]} * p_.points_per_tile + chosen[i]] = static_cast<std::uint16_t>(rank);
            taken_.take(tiles[i], chosen[i]);
        }
    }

    /// The point of a tile without a rank that has the least energy; of several, chance chooses.
    std::uint32_t loneliest_point(std::uint32_t tile, std::uint32_t rank, const Influence& influence) const
    {
        std::array<NeighbourTiles, neighbourhoods> around{};
        for (std::uint32_t i = 0; i < neighbourhoods; ++i) around[i] = random_neighbours(p_, tile, stream_, i);
        std::uint32_t best = 0, best_tie = 0;
        std::uint64_t least = UINT64_MAX;
        for (std::uint32_t point = 0; point < p_.points_per_tile; ++point) {
            if (ranks_[std::size_t{tile} * p_.points_per_tile + point] != unranked) continue;
            const std::uint64_t energy = energy_of(tile, point, around, influence, least);
            const std::uint32_t tie = philox({tile, rank, point, tie_use}, stream_)[0];
            if (energy > least || (energy == least && tie <= best_tie)) continue;
            best = point;
            best_tie = tie;
            least = energy;
        }
        return best;
    }

    /// The energy of a point, or a part of it that is above `least` already.
    std::uint64_t energy_of(std::uint32_t tile, std::uint32_t point,
                            const std::array<NeighbourTiles, neighbourhoods>& around, const Influence& influence,
                            std::uint64_t least) const
    {
        const CoarsePosition& place = points_[std::size_t{tile} * p_.points_per_tile + point];
        std::uint64_t sum = 0; // of the tile itself first, whose points are nearest
        if (const auto cells = taken_.cells_near(place, influence.radius()))
            sum = neighbourhoods * taken_.energy(tile, *cells, place, influence);
        const int layers = p_.dimension == 3 ? 1 : 0;
        for (int z = -layers; z <= layers; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1 && sum <= least; ++x) {
                    const CoarsePosition seen{place[0] - x * coarse_side, place[1] - y * coarse_side,
                                              place[2] - z * coarse_side};
                    const auto cells = taken_.cells_near(seen, influence.radius());
                    if (!cells || (x == 0 && y == 0 && z == 0)) continue;
                    for (const NeighbourTiles& tiles : around)
                        sum += taken_.energy(tiles[neighbour_number(x, y, z)], *cells, seen, influence);
                }
        return sum;
    }

    const PoissonTileParameters& p_;
    StreamKey stream_;
    std::vector<CoarsePosition> points_;
    TakenPoints taken_;
    std::vector<std::uint16_t> ranks_;
};

/// The rank in its tile of each point by its rank in its class, class after class: by the part of its class that is
/// there then.
std::vector<std::uint16_t> ranks_of_classes(const TileClasses& classes)
{
    std::vector<std::uint32_t> points(classes.all_points());
    std::iota(points.begin(), points.end(), 0U);
    const auto part = [&](std::uint32_t point) {
        const std::uint32_t own = classes.class_of(point);
        return (point - classes.first_point(own) + 0.5) / classes.points[own];
    };
    std::ranges::stable_sort(points, {}, part);
    std::vector<std::uint16_t> ranks(points.size());
    for (std::size_t rank = 0; rank < points.size(); ++rank) ranks[points[rank]] = static_cast<std::uint16_t>(rank);
    return ranks;
}

std::vector<std::uint16_t> rank_classes(const PoissonTileSet& set,
                                        const std::function<void(std::size_t done, std::size_t total)>& progress)
{
    const TileClasses& classes = set.parameters.classes;
    const std::uint32_t all = classes.all_points();
    const std::vector<std::uint16_t> together = ranks_of_classes(classes);
    std::vector<std::uint16_t> ranks(std::size_t{set.parameters.tiles} * all);
    for (std::uint32_t own = 0; own < classes.count(); ++own) {
        const std::uint32_t first = classes.first_point(own), count = classes.points[own];
        const std::vector<std::uint16_t> in_class =
            Ranking(class_subset(set, own)).run([&](std::size_t done, std::size_t) {
                if (progress) progress(first + done, all);
            });
        for (std::size_t i = 0; i < in_class.size(); ++i)
            ranks[i / count * all + first + i % count] = together[first + in_class[i]];
    }
    return ranks;
}

}

std::vector<std::uint16_t> rank_points(const PoissonTileSet& set,
                                       const std::function<void(std::size_t done, std::size_t total)>& progress)
{
    if (!set.parameters.classes.is_empty()) return rank_classes(set, progress);
    return Ranking(set).run(progress);
}

}
