#include "host/tile_sampling/recursive/recursive_points.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/random_permutation.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

/// The order in which the tiles of cells get their next points: neighbours are far apart.
constexpr std::array<std::uint64_t, recursive_cells> cell_turns{0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t one_point = std::uint64_t{1} << 32;

/// Collects a torus' points as coordinates.
class Coordinates
{
public:
    explicit Coordinates(std::uint32_t side) : side_(side) {}

    void add(int level, const std::array<std::uint64_t, 2>& cell, const RecursivePlace& place)
    {
        const double size = static_cast<double>(side_) * static_cast<double>(std::uint64_t{1} << 2 * level);
        for (std::size_t k = 0; k < 2; ++k)
            all.push_back((static_cast<double>(cell[k]) + static_cast<double>(place[k]) * 0x1p-32) / size);
    }

    std::vector<double> all;

private:
    std::uint32_t side_;
};

}

/// The mean weight gets points / side^2; the largest one that times pixels * full weight / sum of weights.
RecursiveDensity::RecursiveDensity(std::uint64_t points, std::uint64_t side, int level,
                                   const std::optional<Density>& density)
    : level_(level), is_uniform_(!density)
{
    Wide pixels = 1, sum = full_weight;
    if (density) {
        bounds_ = DensityBounds(*density);
        pixels = density->weights.size();
        sum = 0;
        for (const std::uint64_t weight : density->weights) sum += weight;
    }
    const Wide all = pixels * points << 40, tiles = sum * side * side;
    const Wide whole = all / tiles, part = ((all % tiles) << 32) / tiles;
    if (whole >= std::uint64_t{1} << 31)
        throw InputError(fmt::format("the densest place would get {:.3g} points per tile: must be less than 2^31",
                                     static_cast<double>(whole)));
    most_ = static_cast<std::uint64_t>((whole << 32) + part);
}

/// A tile in its place.
struct RecursiveTiling::Node
{
    std::uint8_t tile = 0;
    std::array<std::uint64_t, 2> cell{};
    std::uint64_t turn = 0;
};

/// Goes through the levels of tiles that meet a window.
class RecursiveTiling::Walk
{
public:
    Walk(const RecursiveTileSet& tiles, const RecursiveWindow& window, const RecursiveDensity& density,
         RecursiveDrawing drawing)
        : tiles_(tiles), window_(window), density_(density), points_(tiles.points_per_tile()), drawing_(drawing)
    {}

    /// Shows all points of a tile, by add(level, cell, place), and the tiles in its cells that have more.
    template <class Add>
    void visit(const Node& node, int level, const Add& add, std::vector<Node>& next) const
    {
        const std::uint64_t most = demand_over(node, level);
        const RankedCell ranked = ranks_of(node, level, most);
        const RecursiveTile& tile = tiles_.tile(node.tile);
        for (std::uint32_t rank = ranked.first; rank < ranked.first + ranked.count; ++rank) {
            const RecursiveLink link = tile.links[rank];
            const std::uint32_t cell = link.cell();
            add_if_wanted({tile.children[cell], cell_of(node, cell), 0}, link.point(), level,
                          rank * one_point + node.turn, add);
        }
        descend(node, level, most, next);
    }

    /// The ranks of a tile whose turn comes before the largest demand over it, `most`.
    RankedCell ranks_of(const Node& node, int level, std::uint64_t most) const
    {
        const bool is_twice = drawing_ == RecursiveDrawing::twice;
        const std::uint64_t first = level > 0 && !is_twice ? points_ : 0;
        const std::uint64_t last = is_twice ? points_ : recursive_cells * points_;
        const std::uint64_t end = most < node.turn ? 0 : std::min(last, (most - node.turn) / one_point + 1);
        return {node.tile, node.cell, node.turn, static_cast<std::uint32_t>(first),
                static_cast<std::uint32_t>(end > first ? end - first : 0)};
    }

    /// Adds the tiles in the cells of a tile that have more. A smaller tile's first sub-point comes when it has more
    /// than N points per tile.
    void descend(const Node& node, int level, std::uint64_t most, std::vector<Node>& next) const
    {
        const std::uint64_t full = points_ * one_point;
        if (drawing_ == RecursiveDrawing::twice ? most <= full : most / recursive_cells < full) return;
        for (std::uint32_t cell = 0; cell < recursive_cells; ++cell) {
            const Node child{tiles_.tile(node.tile).children[cell], cell_of(node, cell),
                             (cell_turns[cell] * one_point + node.turn) / recursive_cells};
            if (meets_window(child, level + 1)) next.push_back(child);
        }
    }

    /// The largest demand over a tile.
    std::uint64_t demand_over(const Node& node, int level) const
    {
        if (density_.is_uniform() || level < window_.level) return density_.demand(full_weight, level);
        return density_.demand(density_.bounds().over(place_in_window(level, node.cell, {0, 0}),
                                                      place_in_window(level, node.cell, {UINT32_MAX, UINT32_MAX})),
                               level);
    }

    bool meets_window(const Node& node, int level) const
    {
        if (level == 0 && window_.level == 0) return true;
        return std::ranges::all_of(std::array<std::size_t, 2>{0, 1}, [&](std::size_t k) {
            const std::uint64_t low = window_.corner[k], high = low + (window_.side - 1); // inclusive
            if (level >= window_.level) {
                const std::uint64_t at = node.cell[k] >> 2 * (level - window_.level);
                return at >= low && at <= high;
            }
            const int down = 2 * (window_.level - level);
            return down >= 64 || (node.cell[k] >= low >> down && node.cell[k] <= high >> down);
        });
    }

private:
    static std::array<std::uint64_t, 2> cell_of(const Node& node, std::uint32_t cell)
    {
        return {node.cell[0] << 2 | (cell & 3U), node.cell[1] << 2 | cell >> 2};
    }

    /// The place of a tile of a level no less than the window's, or of a place in it, in the window of 2^32 units.
    DensityPlace place_in_window(int level, const std::array<std::uint64_t, 2>& cell, const RecursivePlace& place) const
    {
        const int down = 2 * (level - window_.level);
        DensityPlace result{};
        for (std::size_t k = 0; k < 2; ++k) {
            const std::uint64_t from_corner = cell[k] - (window_.corner[k] << down);
            const Wide span = static_cast<Wide>(window_.side) << down;
            const bool is_short = span >> 32 == 0; // nearly always, and much faster
            result[k] = static_cast<std::uint32_t>(
                is_short ? (from_corner << 32 | place[k]) / static_cast<std::uint64_t>(span)
                         : static_cast<std::uint64_t>((static_cast<Wide>(from_corner) << 32 | place[k]) / span));
        }
        return result;
    }

    /// A point of a tile one level below that where it has its rank. It is followed to the window's level.
    template <class Add>
    void add_if_wanted(Node holder, std::uint32_t point, int level_of_rank, std::uint64_t turn, const Add& add) const
    {
        int level = level_of_rank + 1;
        while (level < window_.level) {
            if (!meets_window(holder, level)) return;
            const RecursiveLink link = tiles_.tile(holder.tile).links[point];
            holder = {tiles_.tile(holder.tile).children[link.cell()], cell_of(holder, link.cell()), 0};
            point = link.point();
            ++level;
        }
        if (window_.level > level_of_rank && !meets_window(holder, level)) return;
        const RecursivePlace& place = tiles_.places(holder.tile)[point];
        if (!density_.is_uniform()) {
            const std::uint64_t weight = density_.bounds().at(place_in_window(level, holder.cell, place));
            if (turn > density_.demand(weight, level_of_rank)) return;
        }
        add(level, holder.cell, place);
    }

    const RecursiveTileSet& tiles_;
    const RecursiveWindow& window_;
    const RecursiveDensity& density_;
    std::uint32_t points_;
    RecursiveDrawing drawing_;
};

RecursiveTiling::RecursiveTiling(const RecursiveTileSet& tiles, std::uint32_t side, const StreamKey& stream,
                                 RootTiles roots)
    : tiles_(&tiles), side_(side), root_tiles_(std::move(roots))
{
    const std::uint32_t count = side * side;
    for (const std::uint32_t turn : random_permutation(count, stream, 0))
        root_turns_.push_back((turn + 1) * one_point / count);
}

std::vector<RecursiveTiling::Node> RecursiveTiling::roots() const
{
    std::vector<Node> nodes;
    for (std::uint32_t i = 0; i < side_ * side_; ++i)
        nodes.push_back({static_cast<std::uint8_t>(root_tiles_[i]), {i % side_, i / side_}, root_turns_[i]});
    return nodes;
}

PointSet RecursiveTiling::torus_points(const RecursiveDensity& density, RecursiveDrawing drawing) const
{
    const RecursiveWindow window{0, {0, 0}, side_};
    const Walk walk(*tiles_, window, density, drawing);
    PointSet set{2, {}};
    std::vector<Node> nodes = roots();
    for (int level = 0; !nodes.empty(); ++level) {
        std::vector<Coordinates> found(nodes.size(), Coordinates(side_));
        std::vector<std::vector<Node>> next(nodes.size());
        tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
            walk.visit(
                nodes[i], level,
                [&](int at, const std::array<std::uint64_t, 2>& cell, const RecursivePlace& place) {
                    found[i].add(at, cell, place);
                },
                next[i]);
        });
        nodes.clear();
        for (std::size_t i = 0; i < found.size(); ++i) {
            set.coordinates.insert(set.coordinates.end(), found[i].all.begin(), found[i].all.end());
            nodes.insert(nodes.end(), next[i].begin(), next[i].end());
        }
    }
    return set;
}

void RecursiveTiling::show_levels(const RecursiveDensity& density, RecursiveDrawing drawing,
                                  const std::function<void(int level, const std::vector<RankedCell>&)>& show) const
{
    const RecursiveWindow window{0, {0, 0}, side_};
    const Walk walk(*tiles_, window, density, drawing);
    std::vector<Node> nodes = roots();
    for (int level = 0; !nodes.empty(); ++level) {
        std::vector<RankedCell> ranked;
        std::vector<Node> next;
        for (const Node& node : nodes) {
            const std::uint64_t most = walk.demand_over(node, level);
            ranked.push_back(walk.ranks_of(node, level, most));
            walk.descend(node, level, most, next);
        }
        show(level, ranked);
        nodes = std::move(next);
    }
}

std::vector<RecursivePoint> RecursiveTiling::window_points(const RecursiveWindow& window,
                                                           const RecursiveDensity& density) const
{
    const Wide along = static_cast<Wide>(side_) << 2 * std::clamp(window.level, 0, deepest_recursive_level);
    if (window.level < 0 || window.level > deepest_recursive_level || along > static_cast<Wide>(UINT64_MAX) + 1)
        throw InputError(fmt::format("level {} of {} tiles: must be from 0 to {}, and tiles' numbers below 2^64",
                                     window.level, side_, deepest_recursive_level));
    for (const std::uint64_t from : window.corner)
        if (window.side == 0 || static_cast<Wide>(from) + window.side > along)
            throw InputError("a window that is empty or reaches beyond its torus");
    const Walk walk(*tiles_, window, density, RecursiveDrawing::once);
    std::vector<RecursivePoint> points;
    std::vector<Node> nodes = roots();
    std::erase_if(nodes, [&](const Node& node) { return !walk.meets_window(node, 0); });
    for (int level = 0; !nodes.empty(); ++level) {
        std::vector<Node> next;
        for (const Node& node : nodes)
            walk.visit(
                node, level,
                [&](int at, const std::array<std::uint64_t, 2>& cell, const RecursivePlace& place) {
                    points.push_back({at, cell, place});
                },
                next);
        nodes = std::move(next);
    }
    return points;
}

}
