#include "host/tile_sampling/recursive/recursive_points.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/permutation_hash.hpp"

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

    void add(int level, const RecursiveCell& cell, const RecursivePlace& place)
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

/// The mean weight gets points / tiles; the largest one that times pixels * full weight / sum of weights.
RecursiveDensity::RecursiveDensity(std::uint64_t points, std::array<std::uint64_t, 2> tiles, int level,
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
    const Wide all = pixels * points << 40, parts = sum * tiles[0] * tiles[1];
    const Wide whole = all / parts, part = ((all % parts) << 32) / parts;
    if (whole >= std::uint64_t{1} << 31)
        throw InputError(fmt::format("the densest place would get {:.3g} points per tile: must be less than 2^31",
                                     static_cast<double>(whole)));
    most_ = static_cast<std::uint64_t>((whole << 32) + part);
}

/// A tile of the level above the window's that meets it begins before it by its digit, and so on.
RecursiveFrame::RecursiveFrame(std::vector<std::array<std::uint8_t, 2>> of_levels, std::array<std::uint64_t, 2> size)
    : digits(std::move(of_levels)), sizes(digits.size() + 1, size)
{
    for (std::size_t level = digits.size(); level-- > 0;)
        for (std::size_t k = 0; k < 2; ++k)
            sizes[level][k] = size[k] == 0 ? 0 : (digits[level][k] + sizes[level + 1][k] - 1) / 4 + 1;
}

std::uint64_t turn_of_cell(std::uint32_t cell, std::uint64_t turn)
{
    return (cell_turns[cell] * one_point + turn) / recursive_cells;
}

namespace {

/// Goes through the levels of tiles that meet a window.
class Walk
{
public:
    Walk(const RecursiveTileSet& tiles, const RecursiveFrame& frame, const RecursiveDensity& density,
         RecursiveDrawing drawing)
        : tiles_(tiles), frame_(frame), density_(density), points_(tiles.points_per_tile()), drawing_(drawing)
    {}

    /// Shows all points of a tile, by add(level, cell, place, rank), and the tiles in its cells that have more.
    template <class Add>
    void visit(const RecursiveNode& node, int level, const Add& add, std::vector<RecursiveNode>& next) const
    {
        const std::uint64_t most = demand_over(node, level);
        const RankedCell ranked = ranks_of(node, level, most);
        const RecursiveTile& tile = tiles_.tile(node.tile);
        for (std::uint32_t rank = ranked.first; rank < ranked.first + ranked.count; ++rank) {
            const RecursiveLink link = tile.links[rank];
            const std::uint32_t cell = link.cell();
            add_if_wanted({tile.children[cell], frame_.cell_of(node.cell, level, cell), 0}, link.point(), level,
                          rank * one_point + node.turn,
                          [&](int at, const RecursiveCell& holder, const RecursivePlace& place) {
                              add(at, holder, place, rank);
                          });
        }
        descend(node, level, most, next);
    }

    /// The ranks of a tile whose turn comes before the largest demand over it, `most`.
    RankedCell ranks_of(const RecursiveNode& node, int level, std::uint64_t most) const
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
    void descend(const RecursiveNode& node, int level, std::uint64_t most, std::vector<RecursiveNode>& next) const
    {
        const std::uint64_t full = points_ * one_point;
        if (drawing_ == RecursiveDrawing::twice ? most <= full : most / recursive_cells < full) return;
        for (std::uint32_t cell = 0; cell < recursive_cells; ++cell) {
            const RecursiveCell at = frame_.cell_of(node.cell, level, cell);
            if (frame_.has(at, level + 1))
                next.push_back({tiles_.tile(node.tile).children[cell], at, turn_of_cell(cell, node.turn)});
        }
    }

    /// The largest demand over a tile.
    std::uint64_t demand_over(const RecursiveNode& node, int level) const
    {
        if (density_.is_uniform() || level < frame_.level()) return density_.demand(full_weight, level);
        return density_.demand(density_.bounds().over(place_in_window(level, node.cell, {0, 0}),
                                                      place_in_window(level, node.cell, {UINT32_MAX, UINT32_MAX})),
                               level);
    }

private:
    /// The place of a tile of a level no less than the window's, or of a place in it, in the window of 2^32 units.
    DensityPlace place_in_window(int level, const RecursiveCell& cell, const RecursivePlace& place) const
    {
        const int down = 2 * (level - frame_.level());
        DensityPlace result{};
        for (std::size_t k = 0; k < 2; ++k) {
            const Wide span = static_cast<Wide>(frame_.sizes.back()[k]) << down;
            const bool is_short = span >> 32 == 0; // nearly always, and much faster
            result[k] = static_cast<std::uint32_t>(
                is_short ? (cell[k] << 32 | place[k]) / static_cast<std::uint64_t>(span)
                         : static_cast<std::uint64_t>((static_cast<Wide>(cell[k]) << 32 | place[k]) / span));
        }
        return result;
    }

    /// A point of a tile one level below that where it has its rank. It is followed to the window's level.
    template <class Add>
    void add_if_wanted(RecursiveNode holder, std::uint32_t point, int level_of_rank, std::uint64_t turn,
                       const Add& add) const
    {
        int level = level_of_rank + 1;
        for (; frame_.has(holder.cell, level) && level < frame_.level(); ++level) {
            const RecursiveLink link = tiles_.tile(holder.tile).links[point];
            holder = {tiles_.tile(holder.tile).children[link.cell()], frame_.cell_of(holder.cell, level, link.cell()),
                      0};
            point = link.point();
        }
        if (!frame_.has(holder.cell, level)) return;
        const RecursivePlace& place = tiles_.places(holder.tile)[point];
        if (!density_.is_uniform()) {
            const std::uint64_t weight = density_.bounds().at(place_in_window(level, holder.cell, place));
            if (turn > density_.demand(weight, level_of_rank)) return;
        }
        add(level, holder.cell, place);
    }

    const RecursiveTileSet& tiles_;
    const RecursiveFrame& frame_;
    const RecursiveDensity& density_;
    std::uint32_t points_;
    RecursiveDrawing drawing_;
};

}

std::vector<RecursivePoint> points_in_frame(const RecursiveTileSet& tiles, const RecursiveFrame& frame,
                                            std::vector<RecursiveNode> roots, const RecursiveDensity& density)
{
    const Walk walk(tiles, frame, density, RecursiveDrawing::once);
    std::vector<RecursivePoint> points;
    for (int level = 0; !roots.empty(); ++level) {
        std::vector<RecursiveNode> next;
        for (const RecursiveNode& node : roots)
            walk.visit(
                node, level,
                [&](int at, const RecursiveCell& cell, const RecursivePlace& place, std::uint32_t rank) {
                    points.push_back({at, cell, place, {level, node.cell, rank}});
                },
                next);
        roots = std::move(next);
    }
    return points;
}

RecursiveTiling::RecursiveTiling(const RecursiveTileSet& tiles, std::uint32_t side, const StreamKey& stream,
                                 RootTiles roots)
    : tiles_(&tiles), side_(side), root_tiles_(std::move(roots))
{
    const std::uint32_t count = side * side;
    for (const std::uint32_t turn : random_permutation(count, stream, 0))
        root_turns_.push_back((turn + 1) * one_point / count);
}

std::vector<RecursiveNode> RecursiveTiling::roots() const
{
    std::vector<RecursiveNode> nodes;
    for (std::uint32_t i = 0; i < side_ * side_; ++i)
        nodes.push_back({static_cast<std::uint8_t>(root_tiles_[i]), {i % side_, i / side_}, root_turns_[i]});
    return nodes;
}

PointSet RecursiveTiling::torus_points(const RecursiveDensity& density, RecursiveDrawing drawing) const
{
    const RecursiveFrame frame({}, {side_, side_});
    const Walk walk(*tiles_, frame, density, drawing);
    PointSet set{2, {}};
    std::vector<RecursiveNode> nodes = roots();
    for (int level = 0; !nodes.empty(); ++level) {
        std::vector<Coordinates> found(nodes.size(), Coordinates(side_));
        std::vector<std::vector<RecursiveNode>> next(nodes.size());
        tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
            walk.visit(
                nodes[i], level,
                [&](int at, const RecursiveCell& cell, const RecursivePlace& place, std::uint32_t /*rank*/) {
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
    const RecursiveFrame frame({}, {side_, side_});
    const Walk walk(*tiles_, frame, density, drawing);
    std::vector<RecursiveNode> nodes = roots();
    for (int level = 0; !nodes.empty(); ++level) {
        std::vector<RankedCell> ranked;
        std::vector<RecursiveNode> next;
        for (const RecursiveNode& node : nodes) {
            const std::uint64_t most = walk.demand_over(node, level);
            ranked.push_back(walk.ranks_of(node, level, most));
            walk.descend(node, level, most, next);
        }
        show(level, ranked);
        nodes = std::move(next);
    }
}

}
