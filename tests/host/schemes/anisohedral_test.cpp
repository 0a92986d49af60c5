// The anisohedral octomino: its tiling has two transitivity classes, and no isohedral tiling is possible.
//
// In an isohedral tiling with a tile that has no symmetry, each tile T has one motion that maps the tile at the origin
// to it and all of the tiling to itself. So the tiles S around the tile at the origin obey: the inverse of each T in S
// is in S, and T S agrees with S. All ways to surround an octomino are tried here.
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "tiles/prototiles/periodic_tiling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace poissonlab {
namespace {

using Cell = std::array<int, 2>;

/// A turn of the square lattice, mirrored or not, and a shift.
struct CellMotion
{
    std::array<int, 4> turn{1, 0, 0, 1};
    Cell shift{};

    Cell operator()(const Cell& c) const
    {
        return {turn[0] * c[0] + turn[1] * c[1] + shift[0], turn[2] * c[0] + turn[3] * c[1] + shift[1]};
    }
    CellMotion after(const CellMotion& b) const
    {
        const CellMotion linear{turn, {}};
        const Cell x = linear({b.turn[0], b.turn[2]}), y = linear({b.turn[1], b.turn[3]});
        return {{x[0], y[0], x[1], y[1]}, (*this)(b.shift)};
    }
    CellMotion inverse() const
    {
        const CellMotion back{{turn[0], turn[2], turn[1], turn[3]}, {}};
        const Cell moved = back(shift);
        return {back.turn, {-moved[0], -moved[1]}};
    }
    bool operator==(const CellMotion&) const = default;
};

constexpr std::array<std::array<int, 4>, 8> turns{{{1, 0, 0, 1},
                                                   {0, -1, 1, 0},
                                                   {-1, 0, 0, -1},
                                                   {0, 1, -1, 0},
                                                   {-1, 0, 0, 1},
                                                   {0, 1, 1, 0},
                                                   {1, 0, 0, -1},
                                                   {0, -1, -1, 0}}};

class Surrounds
{
public:
    explicit Surrounds(std::vector<Cell> tile) : tile_(std::move(tile))
    {
        const std::set<Cell> own(tile_.begin(), tile_.end());
        for (const Cell& c : tile_)
            for (int dx = -1; dx <= 1; ++dx)
                for (int dy = -1; dy <= 1; ++dy)
                    if (!own.contains({c[0] + dx, c[1] + dy})) around_.insert({c[0] + dx, c[1] + dy});
    }

    bool has_isohedral_tiling() const { return extend({}, {}); }

private:
    std::set<Cell> cells(const CellMotion& motion) const
    {
        std::set<Cell> all;
        for (const Cell& c : tile_) all.insert(motion(c));
        return all;
    }

    /// True if two tiles are equal or have no cell in common.
    bool agree(const CellMotion& a, const CellMotion& b) const
    {
        if (a == b) return true;
        const std::set<Cell> of_a = cells(a);
        for (const Cell& c : tile_)
            if (of_a.contains(b(c))) return false;
        return true;
    }

    bool is_consistent(const std::vector<CellMotion>& tiles) const
    {
        for (const CellMotion& a : tiles)
            for (const CellMotion& b : tiles) {
                const CellMotion there = a.after(b);
                if (!agree(there, {})) return false;
                for (const CellMotion& c : tiles)
                    if (!agree(there, c)) return false;
            }
        return true;
    }

    bool extend(const std::vector<CellMotion>& tiles, const std::set<Cell>& covered) const
    {
        const Cell* free = nullptr;
        for (const Cell& c : around_)
            if (!covered.contains(c)) free = &c;
        if (!free) return true;
        for (const auto& turn : turns)
            for (const Cell& own : tile_) {
                const Cell turned = CellMotion{turn, {}}(own);
                const CellMotion next{turn, {(*free)[0] - turned[0], (*free)[1] - turned[1]}};
                std::vector<CellMotion> more = tiles;
                std::set<Cell> now = covered;
                bool fits = agree(next, {});
                for (const CellMotion& motion : {next, next.inverse()}) {
                    for (const CellMotion& tile : more) fits = fits && agree(motion, tile);
                    if (std::ranges::find(more, motion) == more.end()) more.push_back(motion);
                    now.merge(cells(motion));
                }
                if (fits && is_consistent(more) && extend(more, now)) return true;
            }
        return false;
    }

    std::vector<Cell> tile_;
    std::set<Cell> around_;
};

TEST(AnisohedralOctomino, HasATilingWithTwoClassesAndNoIsohedralOne)
{
    const auto tiling = transitivity_classes(built_in_tiling("anisohedral-octomino")).tiles;
    EXPECT_EQ(std::set(tiling.begin(), tiling.end()).size(), 2);
    const std::vector<Cell> octomino{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {2, 2}, {3, 2}, {3, 3}, {4, 2}};
    EXPECT_FALSE(Surrounds(octomino).has_isohedral_tiling());
    // Two that have isohedral tilings: the pentomino P, and an L of eight cells.
    EXPECT_TRUE(Surrounds({{0, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 2}}).has_isohedral_tiling());
    EXPECT_TRUE(Surrounds({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {0, 1}}).has_isohedral_tiling());
}

}
}
