#include "host/tile_construction/recursive/recursive_construction.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/random/random.hpp"
#include "host/tile_construction/recursive/tile_views.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

using EdgeWord = std::array<Color, 4>;

/// Words of two zeros and two ones.
constexpr std::array<EdgeWord, 6> even_words{
    {{0, 0, 1, 1}, {0, 1, 0, 1}, {0, 1, 1, 0}, {1, 0, 0, 1}, {1, 0, 1, 0}, {1, 1, 0, 0}}};

/// Two different words, for the two colours of an edge.
std::array<EdgeWord, 2> random_words(const std::array<std::uint32_t, 4>& random, std::size_t first)
{
    const std::uint32_t a = random[first] % 6, b = random[first + 1] % 5;
    return {even_words[a], even_words[b < a ? b : b + 1]};
}

/// Colours from the lower left on: chance decides where two are open, evenness the rest.
TileCells random_division(const WangTile& tile, const std::array<EdgeWord, 2>& horizontal,
                          const std::array<EdgeWord, 2>& vertical, std::uint32_t bits)
{
    TileCells cells{};
    EdgeWord south = horizontal[tile.south];
    for (std::uint32_t y = 0; y < 4; ++y) {
        Color west = vertical[tile.west][y];
        for (std::uint32_t x = 0; x < 4; ++x) {
            WangTile cell{0, 0, south[x], west};
            if (y == 3) {
                cell.north = horizontal[tile.north][x];
                cell.east = cell.north ^ cell.south ^ cell.west;
            } else {
                cell.east = x == 3 ? vertical[tile.east][y] : bits & 1U;
                bits = x == 3 ? bits : bits >> 1;
                cell.north = cell.east ^ cell.south ^ cell.west;
            }
            cells[4 * y + x] = static_cast<std::uint8_t>(even_wang_tile(cell));
            south[x] = cell.north;
            west = cell.east;
        }
    }
    return cells;
}

/// The places of a tile's cells, and the points of this tile and around it that were taken before.
class Candidates
{
public:
    explicit Candidates(const std::vector<RecursivePlace>& places)
        : used_(places.size()), grid_(places.size()), taken_(places.size() / 8)
    {
        for (const RecursivePlace& place : places) grid_.add(plane_place(place));
    }

    bool keeps(std::uint32_t i, std::int64_t distance) const
    {
        return squared_gap(grid_[i], distance) >= distance_squared(distance);
    }

    /// The number of the nearest unused one that keeps a distance from those taken, among those near a place; or the
    /// one that comes nearest to that.
    std::uint32_t choose(const RecursivePlace& place, std::int64_t near, std::int64_t distance) const
    {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> unused;
        for (std::int64_t reach = near; unused.empty(); reach *= 2)
            grid_.visit_near(plane_place(place), reach, [&](std::uint32_t i) {
                if (!used_[i]) unused.emplace_back(squared_between(grid_[i], plane_place(place)), i);
            });
        std::ranges::sort(unused);
        std::uint32_t best = unused.front().second;
        std::uint64_t widest = 0;
        for (const auto& [squared, i] : unused) {
            const std::uint64_t gap = squared_gap(grid_[i], distance);
            if (gap > widest) {
                widest = gap;
                best = i;
            }
            if (gap >= distance_squared(distance)) break;
        }
        return best;
    }

    void use(std::uint32_t i, bool used) { used_[i] = used; }
    void add_taken(const PlanePlace& place) { taken_.add(place); }

private:
    static std::uint64_t distance_squared(std::int64_t distance)
    {
        return static_cast<std::uint64_t>(distance * distance);
    }

    /// The squared distance of the nearest point taken, at most that of `distance`.
    std::uint64_t squared_gap(const PlanePlace& place, std::int64_t distance) const
    {
        std::uint64_t gap = distance_squared(distance);
        taken_.visit_near(place, distance,
                          [&](std::uint32_t i) { gap = std::min(gap, squared_between(taken_[i], place)); });
        return gap;
    }

    std::vector<bool> used_;
    PlaceGrid grid_, taken_;
};

constexpr double kept_part = 0.5;   ///< of the largest distance of as many points, for a point to stay
constexpr double chosen_part = 0.6; ///< for a point to move to
constexpr int most_rounds = 40;

/// Chooses links where there are none yet, and anew for points that are too near to one of a lower rank. Returns how
/// many became others.
std::size_t mend_links(const RecursivePlaces& places, const RecursivePlaces& candidates, TileLinks& links)
{
    const auto points = static_cast<std::uint32_t>(places[0].size());
    const auto length = [](double sides) { return static_cast<std::int64_t>(std::min(0.5, sides) * tile_side); };
    const auto number = [&](RecursiveLink link) { return link.cell() * points + link.point(); };
    std::vector<Candidates> tiles;
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        tiles.emplace_back(candidates[i]);
        for (const RecursiveLink link : links[i]) tiles[i].use(number(link), true);
    }
    std::size_t changes = 0;
    for (std::uint32_t rank = 0; rank < points; ++rank) {
        const double largest = max_min_distance(rank + 1, 2);
        for (std::size_t i = 0; i < even_wang_tiles; ++i) {
            const bool is_first = rank == links[i].size();
            if (is_first || !tiles[i].keeps(number(links[i][rank]), length(kept_part * largest))) {
                const std::uint32_t before = is_first ? 0 : number(links[i][rank]);
                if (is_first)
                    links[i].emplace_back();
                else
                    tiles[i].use(before, false);
                const std::uint32_t chosen = tiles[i].choose(places[i][rank], length(max_min_distance(points, 2)),
                                                             length(chosen_part * largest));
                tiles[i].use(chosen, true);
                links[i][rank] = RecursiveLink::to(chosen / points, chosen % points);
                changes += is_first || chosen != before;
            }
            visit_views(i, candidates[i][number(links[i][rank])], length(largest),
                        [&](std::size_t by, const PlanePlace& seen) { tiles[by].add_taken(seen); });
        }
    }
    return changes;
}

}

std::array<TileCells, even_wang_tiles> random_divisions(std::uint64_t seed)
{
    const StreamKey stream = stream_key(seed, Purpose::recursive_tile_words, 0);
    const auto words = philox({0, 0, 0, 0}, stream);
    const auto horizontal = random_words(words, 0), vertical = random_words(words, 2);
    std::array<TileCells, even_wang_tiles> cells;
    for (std::uint32_t i = 0; i < even_wang_tiles; ++i)
        cells[i] = random_division(wang_colors_of(i), horizontal, vertical, philox({1 + i, 0, 0, 0}, stream)[0]);
    return cells;
}

std::vector<RecursivePlace> places_in_cells(const RecursivePlaces& places, const TileCells& cells)
{
    std::vector<RecursivePlace> all;
    for (std::uint32_t cell = 0; cell < recursive_cells; ++cell)
        for (const RecursivePlace& place : places[cells[cell]]) all.push_back(place_in_parent(cell, place));
    return all;
}

TileLinks own_points(RecursivePlaces places, const std::array<TileCells, even_wang_tiles>& cells)
{
    TileLinks links;
    for (int round = 0; round < most_rounds; ++round) {
        RecursivePlaces candidates;
        for (std::size_t i = 0; i < even_wang_tiles; ++i) candidates[i] = places_in_cells(places, cells[i]);
        if (mend_links(places, candidates, links) == 0) break;
        RecursiveTiles tiles;
        for (std::size_t i = 0; i < even_wang_tiles; ++i) tiles[i] = {cells[i], links[i]};
        places = places_of_links(tiles, static_cast<std::uint32_t>(places[0].size()));
    }
    return links;
}

}
