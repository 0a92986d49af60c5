#include "tiles/tilings/tiling.hpp"

#include "base/errors/errors.hpp"
#include "tiles/tilings/direct_tiling.hpp"
#include "tiles/tilings/row_arithmetic.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

// Rows of tiles of a direct tiling, made from rows of lattice colours.
//
// Gives the tiles that direct_tiling.hpp gives, faster: neighbours in a row, and rows below each other, share
// lattice points, which are evaluated once.

// Rows of lattice colours for streaming tiles, each evaluated once.

/// Lattice points in a row, one a tile: those at (scale X + offset, y), where X is the coordinate x, x + 1,
/// ... of the tile, reduced to the period.
struct PointRow
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::uint8_t scale = 1; ///< 2: on the lattice that is twice as dense
    std::uint8_t offset = 0;
    std::size_t count = 0;

    bool operator==(const PointRow&) const = default;
};

/// The colours of hash functions along rows of the lattice. The last two rows of each of three series are
/// kept, so that a row that bounds two rows of tiles is evaluated once.
class LatticeRows
{
public:
    /// `period`: of the tiles along x, 0 where they do not close.
    explicit LatticeRows(std::int64_t period) : torus_{{period, 0, 0}} {}

    /// The colours of the points. Valid until two other rows were asked for in the same series (0, 1 or 2),
    /// which must always be of the same hash function.
    const std::uint8_t* row(unsigned series, const ColorHash& hash, const PointRow& points);

private:
    struct Row
    {
        PointRow points;
        std::vector<std::uint8_t> colors; ///< at least as many as points
    };

    void evaluate(Row& row, const ColorHash& hash) const;

    Torus torus_;
    std::array<std::array<Row, 2>, 3> kept_;
    std::array<unsigned, 3> newest_{};
};

class TileRows
{
public:
    /// Rows that are evaluated in one piece stay in the processor's cache.
    static constexpr std::size_t longest = 8192;

    /// Refers to the tiling, which must stay.
    explicit TileRows(const Tiling& tiling);

    /// The indices of the tiles from (x, y) eastwards, at most `longest` of them.
    void fill(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);

private:
    void fill_corner(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);
    void fill_corner_sums(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);
    void fill_edges(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);

    const Tiling& tiling_;
    LatticeRows rows_;
    std::vector<std::uint8_t> north_; ///< edge colours, where these are sums
    std::vector<std::uint8_t> south_;
    std::vector<std::uint8_t> vertical_;
};

/// The number of steps from a coordinate to the last one.
std::uint64_t steps_to(std::int64_t last, std::int64_t from)
{
    return static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(from);
}

const std::uint8_t* LatticeRows::row(unsigned series, const ColorHash& hash, const PointRow& points)
{
    auto& kept = kept_[series];
    unsigned& newest = newest_[series];
    for (unsigned i = 0; i < 2; ++i) {
        if (kept[i].points != points) continue;
        newest = i;
        return kept[i].colors.data();
    }
    newest = 1 - newest;
    Row& row = kept[newest];
    row.points = points;
    if (row.colors.size() < points.count) row.colors.resize(points.count);
    evaluate(row, hash);
    return row.colors.data();
}

void LatticeRows::evaluate(Row& row, const ColorHash& hash) const
{
    const PointRow& points = row.points;
    std::span<std::uint8_t> left(row.colors.data(), points.count);
    std::int64_t x = points.x;
    std::visit(
        [&](const auto& h) {
            while (!left.empty()) {
                // One piece ends where a coordinate starts again: the tile's, the reduced one, or the lattice point's.
                const std::int64_t reduced = torus_.x(x);
                const std::int64_t first = stepped(points.scale == 2 ? doubled(reduced) : reduced, points.offset);
                std::uint64_t steps = std::min(steps_to(INT64_MAX, x), steps_to(INT64_MAX, first) / points.scale);
                if (torus_.period.x > 0) steps = std::min(steps, steps_to(torus_.period.x - 1, reduced));
                const std::size_t count = std::min<std::uint64_t>(left.size() - 1, steps) + 1;
                h.fill_row(first, points.scale, points.y, left.first(count));
                left = left.subspan(count);
                x = stepped(x, count);
            }
        },
        hash);
}

TileRows::TileRows(const Tiling& tiling) : tiling_(tiling), rows_(tiling.period().x) {}

void TileRows::fill(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    switch (tiling_.algorithm()) {
    case DirectAlgorithm::corner:
        return fill_corner(x, y, tiles);
    case DirectAlgorithm::wang_two_hashes:
    case DirectAlgorithm::wang_one_hash:
        return fill_corner_sums(x, y, tiles);
    case DirectAlgorithm::wang_edge_hash:
        return fill_edges(x, y, tiles);
    }
}

void TileRows::fill_corner(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    const Torus torus{tiling_.period()};
    const std::size_t points = tiles.size() + 1;
    const auto* north = rows_.row(0, tiling_.hash(), {x, torus.y(stepped(y, 1)), 1, 0, points});
    const auto* south = rows_.row(0, tiling_.hash(), {x, torus.y(y), 1, 0, points});
    index_corner_tiles(south, north, tiling_.tile_set().colors().horizontal, tiles);
}

void TileRows::fill_corner_sums(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    const Torus torus{tiling_.period()};
    const WangColors colors = tiling_.tile_set().colors();
    const std::size_t points = tiles.size() + 1;
    const PointRow north_points{x, torus.y(stepped(y, 1)), 1, 0, points};
    const PointRow south_points{x, torus.y(y), 1, 0, points};
    const auto* north = rows_.row(0, tiling_.hash(), north_points);
    const auto* south = rows_.row(0, tiling_.hash(), south_points);
    north_.resize(tiles.size());
    south_.resize(tiles.size());
    add_colors(north, north + 1, colors.horizontal, north_);
    add_colors(south, south + 1, colors.horizontal, south_);
    if (tiling_.algorithm() == DirectAlgorithm::wang_two_hashes) {
        north = rows_.row(1, tiling_.vertical_hash(), north_points);
        south = rows_.row(1, tiling_.vertical_hash(), south_points);
    }
    vertical_.resize(points);
    add_colors(south, north, colors.vertical, vertical_);
    index_wang_tiles(north_.data(), south_.data(), vertical_.data(), colors, tiles);
}

void TileRows::fill_edges(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles)
{
    const Torus torus{tiling_.period()};
    const std::int64_t south_y = doubled(torus.y(y));
    const std::int64_t north_y = doubled(torus.y(stepped(y, 1)));
    const auto* north = rows_.row(0, tiling_.hash(), {x, north_y, 2, 1, tiles.size()});
    const auto* south = rows_.row(0, tiling_.hash(), {x, south_y, 2, 1, tiles.size()});
    const auto* vertical = rows_.row(2, tiling_.vertical_hash(), {x, stepped(south_y, 1), 2, 0, tiles.size() + 1});
    index_wang_tiles(north, south, vertical, tiling_.tile_set().colors(), tiles);
}

TileSet tile_set_of(DirectAlgorithm algorithm, WangColors colors)
{
    if (algorithm == DirectAlgorithm::corner) return TileSet::complete(TileKind::corner, colors);
    if (algorithm == DirectAlgorithm::wang_one_hash) return one_hash_wang_set(colors.horizontal);
    return TileSet::complete(TileKind::wang, colors);
}

WangColors checked_colors(DirectAlgorithm algorithm, WangColors colors)
{
    const bool must_be_same = algorithm == DirectAlgorithm::corner || algorithm == DirectAlgorithm::wang_one_hash;
    if (must_be_same && colors.horizontal != colors.vertical)
        throw InputError("colors = " + std::to_string(colors.horizontal) + " x " + std::to_string(colors.vertical) +
                         ": this algorithm has one number of colours");
    return colors;
}

/// Two hash functions differ, two kinds of edges with one hash function only if they must.
std::uint32_t vertical_stream(DirectAlgorithm algorithm, WangColors colors)
{
    const bool one = algorithm == DirectAlgorithm::wang_edge_hash && colors.horizontal == colors.vertical;
    return one || algorithm == DirectAlgorithm::corner || algorithm == DirectAlgorithm::wang_one_hash ? 0 : 1;
}

template <class Hash, class Lattice>
TileIndex tile_at(DirectAlgorithm algorithm, WangColors colors, const Hash& horizontal, const Hash& vertical,
                  const Lattice& lattice, std::int64_t x, std::int64_t y)
{
    switch (algorithm) {
    case DirectAlgorithm::corner:
        return corner_index(direct_corner_tile(horizontal, lattice, x, y), colors.horizontal);
    case DirectAlgorithm::wang_two_hashes:
        return wang_index(two_hash_wang_tile(horizontal, vertical, lattice, x, y), colors);
    case DirectAlgorithm::wang_one_hash:
        return wang_index(one_hash_wang_tile(horizontal, lattice, x, y), colors);
    case DirectAlgorithm::wang_edge_hash:
        return wang_index(edge_hash_wang_tile(horizontal, vertical, lattice, x, y), colors);
    }
    return 0;
}

}

Tiling::Tiling(DirectAlgorithm algorithm, WangColors colors, const HashChoice& hash, std::uint64_t seed, Period period)
    : algorithm_(algorithm), colors_(checked_colors(algorithm, colors)), tile_set_(tile_set_of(algorithm, colors)),
      period_(checked_period(period)), horizontal_(make_color_hash(hash, colors.horizontal, seed)),
      vertical_(make_color_hash(hash, colors.vertical, seed, vertical_stream(algorithm, colors)))
{}

TileIndex Tiling::tile(std::int64_t x, std::int64_t y) const
{
    return std::visit(
        [&](const auto& horizontal) {
            const auto& vertical = *std::get_if<std::remove_cvref_t<decltype(horizontal)>>(&vertical_);
            if (period_ == Period{}) return tile_at(algorithm_, colors_, horizontal, vertical, Plane{}, x, y);
            return tile_at(algorithm_, colors_, horizontal, vertical, Torus{period_}, x, y);
        },
        horizontal_);
}

void Tiling::fill_row(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles) const
{
    TileRows rows(*this);
    while (!tiles.empty()) {
        const std::size_t count = std::min<std::size_t>(tiles.size(), TileRows::longest);
        rows.fill(x, y, tiles.first(count));
        tiles = tiles.subspan(count);
        x = stepped(x, count);
    }
}

void Tiling::stream(const TileWindow& window, const TileSink& sink) const
{
    TileRows rows(*this);
    std::vector<TileIndex> tiles(std::min<std::uint64_t>(window.width, TileRows::longest));
    for (std::uint64_t row = 0; row < window.height; ++row) {
        const std::int64_t y = stepped(window.y, window.height - 1 - row);
        for (std::uint64_t begin = 0; begin < window.width; begin += tiles.size()) {
            const std::int64_t x = stepped(window.x, begin);
            const std::span piece(tiles.data(), std::min<std::uint64_t>(tiles.size(), window.width - begin));
            rows.fill(x, y, piece);
            sink(x, y, piece);
        }
    }
}

}
