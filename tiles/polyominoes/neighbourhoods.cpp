#include "tiles/polyominoes/neighbourhoods.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

constexpr std::uint32_t no_polyomino = std::numeric_limits<std::uint32_t>::max();

/// The tiles that have the cells of the plane, or of a torus.
class TileMap
{
public:
    /// `period` 0: of the plane.
    TileMap(Polyomino shape, const std::vector<Pose>& tiles, std::int64_t period = 0) : tiles_(tiles), period_(period)
    {
        find_extent(shape);
        cells_.resize(static_cast<std::size_t>(width_ * height_));
        for (std::uint32_t i = 0; i < tiles.size(); ++i)
            for (const LatticePlace& cell : cells_of(shape)) {
                const LatticePlace place = moved_cell(tiles[i], cell);
                cells_[index_of(place)] = {i, place};
            }
    }

    /// The tile of a cell that belongs to a tile or lies beside one; nothing where there is none.
    std::optional<Pose> operator[](const LatticePlace& cell) const
    {
        const Cell& found = cells_[index_of(cell)];
        if (found.tile == no_polyomino) return std::nullopt;
        const Pose& tile = tiles_[found.tile];
        return Pose{tile.shift + (cell - found.place), tile.turn};
    }

private:
    struct Cell
    {
        std::uint32_t tile = no_polyomino;
        LatticePlace place; ///< of the tile as it was given; the same but for periods
    };

    void find_extent(Polyomino shape)
    {
        width_ = height_ = period_;
        if (period_ > 0) return;
        LatticePlace highest = moved_cell(tiles_.front(), {});
        lowest_ = highest;
        for (const Pose& tile : tiles_)
            for (const LatticePlace& cell : cells_of(shape)) {
                const LatticePlace place = moved_cell(tile, cell);
                lowest_ = {std::min(lowest_.x, place.x), std::min(lowest_.y, place.y)};
                highest = {std::max(highest.x, place.x), std::max(highest.y, place.y)};
            }
        lowest_ = lowest_ - LatticePlace{1, 1}; // a border without tiles
        width_ = highest.x - lowest_.x + 2;
        height_ = highest.y - lowest_.y + 2;
    }

    std::size_t index_of(const LatticePlace& cell) const
    {
        LatticePlace place = cell - lowest_;
        if (period_ > 0) place = {wrapped(place.x), wrapped(place.y)};
        return static_cast<std::size_t>(place.y * width_ + place.x);
    }

    std::int64_t wrapped(std::int64_t c) const { return (c % period_ + period_) % period_; }

    const std::vector<Pose>& tiles_;
    std::int64_t period_;
    LatticePlace lowest_;
    std::int64_t width_ = 0;
    std::int64_t height_ = 0;
    std::vector<Cell> cells_;
};

/// Calls `action` with each of the 3 x 3 cells around each cell of a tile.
template <class Action>
void for_cells_around(Polyomino shape, const Pose& tile, const Action& action)
{
    for (const LatticePlace& cell : cells_of(shape)) {
        const LatticePlace middle = moved_cell(tile, cell);
        for (std::int64_t y = -1; y <= 1; ++y)
            for (std::int64_t x = -1; x <= 1; ++x) action(middle + LatticePlace{x, y});
    }
}

/// The collar of a tile, empty where a neighbour is missing.
Collar collar_in(const TileMap& map, Polyomino shape, const Pose& tile)
{
    Collar collar;
    bool is_whole = true;
    for_cells_around(shape, tile, [&](const LatticePlace& cell) {
        const std::optional<Pose> other = map[cell];
        is_whole = is_whole && other;
        if (other && *other != tile && std::ranges::find(collar, *other) == collar.end()) collar.push_back(*other);
    });
    if (!is_whole) return {};
    for (Pose& other : collar) other = seen_from(tile, other);
    std::ranges::sort(collar);
    return collar;
}

std::vector<Collar> collars_in(const TileMap& map, Polyomino shape, const std::vector<Pose>& tiles)
{
    std::vector<Collar> collars;
    for (const Pose& tile : tiles) collars.push_back(collar_in(map, shape, tile));
    return collars;
}

bool overlap(Polyomino shape, const Pose& a, const Pose& b)
{
    for (const LatticePlace& cell : cells_of(shape))
        for (const LatticePlace& other : cells_of(shape))
            if (moved_cell(a, cell) == moved_cell(b, other)) return true;
    return false;
}

/// The least of a figure's eight turns about the origin.
std::vector<Pose> canonical(const std::vector<Pose>& figure)
{
    std::vector<Pose> least;
    for (Turn turn = 0; turn < turns; ++turn) {
        std::vector<Pose> other;
        for (const Pose& tile : figure) other.push_back(composed(Pose{{}, turn}, tile));
        std::ranges::sort(other);
        if (least.empty() || other < least) least = std::move(other);
    }
    return least;
}

/// Shifts of near tiles are at most so long along an axis: tiles are 3 cells high at most.
constexpr std::int64_t near_reach = 8;

bool are_far(const LatticePlace& shift, const LatticePlace& other)
{
    return std::abs(other.x - shift.x) > near_reach || std::abs(other.y - shift.y) > near_reach;
}

/// The poses of near tiles, looked up.
class NearPoses
{
public:
    explicit NearPoses(Polyomino shape)
    {
        for (Turn turn = 0; turn < turns; ++turn)
            for (std::int64_t y = -near_reach; y <= near_reach; ++y)
                for (std::int64_t x = -near_reach; x <= near_reach; ++x)
                    poses_.push_back(has_near_cells(shape, {{x, y}, turn}));
    }

    bool has(const Pose& pose) const
    {
        const auto index = (pose.turn * side + pose.shift.y + near_reach) * side + pose.shift.x + near_reach;
        return poses_[static_cast<std::size_t>(index)];
    }

private:
    static bool has_near_cells(Polyomino shape, const Pose& pose)
    {
        if (pose == Pose{}) return false;
        for (const LatticePlace& cell : cells_of(shape))
            for (const LatticePlace& its : cells_of(shape)) {
                const LatticePlace step = moved_cell(pose, its) - cell;
                if (std::abs(step.x) <= 2 && std::abs(step.y) <= 2) return true;
            }
        return false;
    }

    static constexpr std::int64_t side = 2 * near_reach + 1;

    std::vector<bool> poses_;
};

constexpr std::array<LatticePlace, 4> corner_cells{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};

void complete_figure(Polyomino shape, std::vector<Pose>& figure, std::size_t done, std::set<std::vector<Pose>>& found)
{
    if (done == corner_cells.size()) {
        found.insert(canonical(figure));
        return;
    }
    const auto covers = [&](const Pose& tile) {
        return std::ranges::any_of(
            cells_of(shape), [&](const LatticePlace& cell) { return moved_cell(tile, cell) == corner_cells[done]; });
    };
    if (std::ranges::any_of(figure, covers)) {
        complete_figure(shape, figure, done + 1, found);
        return;
    }
    for (Turn turn = 0; turn < turns; ++turn)
        for (const LatticePlace& cell : cells_of(shape)) {
            const Pose tile{corner_cells[done] - moved_cell({{}, turn}, cell), turn};
            if (std::ranges::any_of(figure, [&](const Pose& other) { return overlap(shape, tile, other); })) continue;
            figure.push_back(tile);
            complete_figure(shape, figure, done + 1, found);
            figure.pop_back();
        }
}

/// Builds the automaton: classes and pairs are worked off in the order of their first occurrence.
class NeighbourhoodClosure
{
public:
    explicit NeighbourhoodClosure(const PolyominoRule& rule)
    {
        all_.rule = rule;
        all_.first_level = first_level_of(rule.shape);
    }

    Neighbourhoods run()
    {
        for (const auto& figure : corner_figures(all_.rule.shape)) add_divided(figure);
        for (std::uint32_t i = 0; i < all_.collars.size(); ++i) add_children(i);
        for (std::uint32_t i = 0; i < all_.collars.size(); ++i) add_pairs_of_children({i, i, Pose{}});
        for (std::size_t i = 0; i < open_.size(); ++i) add_pairs_of_children(NearTiles(open_[i]));
        all_.pairs.assign(pairs_.begin(), pairs_.end());
        return std::move(all_);
    }

private:
    std::uint32_t add_class(const Collar& collar)
    {
        const auto [entry, is_new] = classes_.emplace(collar, static_cast<std::uint32_t>(classes_.size()));
        if (is_new) all_.collars.push_back(collar);
        return entry->second;
    }

    void add_pair(const NearTiles& pair)
    {
        if (pairs_.insert(pair).second) open_.push_back(pair);
    }

    void add_divided(const std::vector<Pose>& figure)
    {
        const std::vector<Pose> tiles = divided(all_.rule, figure, all_.first_level);
        const std::vector<Collar> collars = collars_within(all_.rule.shape, tiles);
        std::vector<std::pair<std::uint32_t, Pose>> whole;
        for (std::size_t i = 0; i < tiles.size(); ++i)
            if (!collars[i].empty()) whole.emplace_back(add_class(collars[i]), tiles[i]);
        for (const auto& [first, tile] : whole)
            for (const auto& [second, other] : whole) {
                if (are_far(tile.shift, other.shift)) continue;
                if (const Pose seen = seen_from(tile, other); is_near(all_.rule.shape, seen))
                    add_pair({first, second, seen});
            }
    }

    void add_children(std::uint32_t number)
    {
        std::vector<Pose> parents{Pose{}};
        parents.insert(parents.end(), all_.collars[number].begin(), all_.collars[number].end());
        const std::vector<Pose> tiles = divided(all_.rule, parents, 1);
        const TileMap map(all_.rule.shape, tiles);
        for (std::uint32_t child = 0; child < all_.rule.children.size(); ++child)
            all_.next.push_back(add_class(collar_in(map, all_.rule.shape, tiles[child])));
    }

    void add_pairs_of_children(const NearTiles& parents)
    {
        for_near_children(all_, parents, [&](const NearTiles& pair) { add_pair(pair); });
    }

    Neighbourhoods all_;
    std::map<Collar, std::uint32_t> classes_;
    std::set<NearTiles> pairs_;
    std::vector<NearTiles> open_;
};

}

bool is_near(Polyomino shape, const Pose& other)
{
    static const NearPoses p(Polyomino::P), g(Polyomino::G);
    return !are_far({}, other.shift) && (shape == Polyomino::P ? p : g).has(other);
}

void for_near_children(const Neighbourhoods& all, const NearTiles& parents,
                       const std::function<void(const NearTiles&)>& action)
{
    const std::size_t count = all.rule.children.size();
    std::vector<Pose> others;
    for (std::size_t j = 0; j < count; ++j) others.push_back(all.rule.child(parents.pose, j));
    for (std::size_t i = 0; i < count; ++i) {
        const Pose back = inverse(all.rule.children[i]);
        for (std::size_t j = 0; j < count; ++j)
            if (const Pose seen = composed(back, others[j]); is_near(all.rule.shape, seen))
                action({all.child_class(parents.first, i), all.child_class(parents.second, j), seen});
    }
}

std::vector<Collar> collars_within(Polyomino shape, const std::vector<Pose>& tiles)
{
    return collars_in(TileMap(shape, tiles), shape, tiles);
}

std::vector<Collar> collars_on_torus(Polyomino shape, const std::vector<Pose>& tiles, std::int64_t period)
{
    return collars_in(TileMap(shape, tiles, period), shape, tiles);
}

std::vector<std::vector<Pose>> corner_figures(Polyomino shape)
{
    std::set<std::vector<Pose>> found;
    std::vector<Pose> figure;
    complete_figure(shape, figure, 0, found);
    return {found.begin(), found.end()};
}

std::vector<Pose> divided(const PolyominoRule& rule, std::vector<Pose> tiles, std::uint32_t divisions)
{
    for (; divisions > 0; --divisions) {
        std::vector<Pose> children;
        for (const Pose& tile : tiles)
            for (std::size_t i = 0; i < rule.children.size(); ++i) children.push_back(rule.child(tile, i));
        tiles = std::move(children);
    }
    return tiles;
}

Neighbourhoods neighbourhoods_of(const PolyominoRule& rule) { return NeighbourhoodClosure(rule).run(); }

std::uint32_t class_of(const Neighbourhoods& neighbourhoods, const Collar& collar)
{
    const auto& collars = neighbourhoods.collars;
    return static_cast<std::uint32_t>(std::ranges::find(collars, collar) - collars.begin());
}

}
