// Penrose subdivisions in exact integers: areas, counts, codes and places.
#include "tiles/penrose/penrose_tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace poissonlab {
namespace {

std::vector<PenroseTile> next_level(const std::vector<PenroseTile>& tiles)
{
    std::vector<PenroseTile> next;
    for (const PenroseTile& tile : tiles)
        for (const PenroseTile& child : divided(tile)) next.push_back(child);
    return next;
}

std::vector<PenroseTile> tiles_of_level(int level)
{
    std::vector<PenroseTile> tiles{PenroseTile{}};
    for (int i = 0; i < level; ++i) tiles = next_level(tiles);
    return tiles;
}

/// m + n phi
struct Golden
{
    std::int64_t m = 0, n = 0;
    bool operator==(const Golden&) const = default;
};

Golden operator+(const Golden& a, const Golden& b) { return {a.m + b.m, a.n + b.n}; }
Golden operator*(const Golden& a, const Golden& b) // phi^2 = phi + 1
{
    return {a.m * b.m + a.n * b.n, a.m * b.n + a.n * b.m + a.n * b.n};
}

/// Twice the area of a triangle p1 p2 p3 over sin 36: the imaginary part of conj(p2 - p1) (p3 - p1). The products of
/// two powers of z have the imaginary parts sin(36 k) = sin 36 {0, 1, phi, phi}, by their difference k.
Golden twice_ring_area(const std::array<RingPlace, 3>& corners)
{
    const auto side = [&](std::size_t corner, std::size_t k) { return corners[corner].c[k] - corners[0].c[k]; };
    Golden area;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const std::int64_t product = side(1, i) * side(2, j) * (j > i ? 1 : -1);
            const std::size_t k = j > i ? j - i : i - j;
            if (k == 1) area.m += product;
            if (k > 1) area.n += product;
        }
    return area;
}

/// Mirrored triangles have a negative one.
Golden positive(const Golden& a)
{
    const bool is_negative = static_cast<double>(a.m) + static_cast<double>(a.n) * 1.618033988749895 < 0;
    return is_negative ? Golden{-a.m, -a.n} : a;
}

TEST(PenroseTiles, KeepTheirAreaExactly)
{
    Golden expected = positive(twice_ring_area(corners_of(PenroseTile{})));
    EXPECT_EQ(expected, (Golden{1, 2})); // phi^3: sides phi^2 and phi with 36 degrees between
    for (int level = 1; level <= 10; ++level) {
        expected = expected * Golden{1, 1}; // units are shorter by phi
        Golden sum;
        for (const PenroseTile& tile : tiles_of_level(level))
            if (!is_point(tile)) sum = sum + positive(twice_ring_area(corners_of(tile)));
        EXPECT_EQ(sum, expected) << level;
    }
}

TEST(PenroseTiles, AreAsManyAsTheRulesSay)
{
    // Rows: children of A to F, by kind.
    constexpr std::array<std::array<std::uint64_t, 6>, 6> rules{{{0, 1, 0, 0, 0, 0},
                                                                 {1, 0, 0, 0, 0, 0},
                                                                 {1, 0, 1, 0, 0, 1},
                                                                 {0, 0, 0, 1, 1, 0},
                                                                 {1, 0, 1, 0, 1, 1},
                                                                 {1, 0, 0, 1, 1, 1}}};
    std::array<std::uint64_t, 6> expected{0, 0, 0, 0, 0, 1};
    for (int level = 0; level <= 10; ++level) {
        std::array<std::uint64_t, 6> counts{};
        for (const PenroseTile& tile : tiles_of_level(level)) ++counts[static_cast<std::size_t>(tile.kind)];
        EXPECT_EQ(counts, expected) << level;
        std::array<std::uint64_t, 6> next{};
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j) next[j] += expected[i] * rules[i][j];
        expected = next;
    }
}

/// The only representation of a number by Fibonacci numbers without two neighbours, F_2 first.
std::vector<int> zeckendorf(std::uint64_t value, int digits)
{
    std::vector<int> code(static_cast<std::size_t>(digits));
    for (int n = digits + 1; n >= 2; --n) {
        if (fibonacci(n) > value) continue;
        value -= fibonacci(n);
        code[static_cast<std::size_t>(n - 2)] = 1;
    }
    return code;
}

TEST(PenroseTiles, HaveCodesOfTheirOwn)
{
    for (int level = 1; level <= 10; ++level) {
        std::set<std::uint64_t> values;
        std::size_t points = 0;
        for (const PenroseTile& tile : tiles_of_level(level)) {
            ASSERT_LT(tile.value, fibonacci(2 * level + 2));
            // The newest pair is that of F_2L and F_2L+1.
            const auto code = zeckendorf(tile.value, 2 * level);
            for (int pair = 0; pair < std::min(3, level); ++pair) {
                const auto low = static_cast<std::size_t>(2 * (level - pair) - 2);
                EXPECT_EQ(tile.digits >> 2 * pair & 3, code[low] + 2 * code[low + 1]);
            }
            if (!is_point(tile)) continue;
            ++points;
            values.insert(tile.value);
        }
        EXPECT_EQ(values.size(), points) << level;
    }
}

TEST(PenroseTiles, HavePointsAtDifferentCornersOfTriangles)
{
    std::set<std::array<std::int64_t, 4>> corners, places;
    std::size_t points = 0;
    for (const PenroseTile& tile : tiles_of_level(8)) {
        if (!is_point(tile)) {
            for (const RingPlace& corner : corners_of(tile)) corners.insert(corner.c);
            EXPECT_EQ(tile.direction % 2, 0);
            continue;
        }
        ++points;
        places.insert(tile.p1.c);
    }
    EXPECT_EQ(places.size(), points);
    EXPECT_TRUE(std::ranges::includes(corners, places));
    // All corners are points but for some of those on the root's own border.
    auto root = corners_of(PenroseTile{});
    for (RingPlace& corner : root)
        for (int level = 0; level < 8; ++level) corner = times_phi(corner);
    for (const auto& corner : corners) {
        const auto is_on_side = [&](std::size_t i) {
            return twice_ring_area({root[i], root[(i + 1) % 3], {corner}}) == Golden{};
        };
        EXPECT_TRUE(places.contains(corner) || is_on_side(0) || is_on_side(1) || is_on_side(2));
    }
}

TEST(PenroseTiles, HaveTheIndicesZeroToTwenty)
{
    std::set<int> found;
    for (const PenroseTile& tile : tiles_of_level(7))
        if (is_point(tile)) found.insert(structural_index(tile.digits));
    EXPECT_EQ(static_cast<int>(found.size()), structural_indices);
    EXPECT_EQ(*found.begin(), 0);
    EXPECT_EQ(*found.rbegin(), structural_indices - 1);
}

TEST(FibonacciNumbers, AreThoseOfTheEncyclopedia) // OEIS A000045
{
    EXPECT_EQ(fibonacci(1), 1U);
    EXPECT_EQ(fibonacci(2), 1U);
    EXPECT_EQ(fibonacci(12), 144U);
    EXPECT_EQ(fibonacci(93), 12200160415121876738U);
}

}
}
