// Tilings with aperiodic sets: by Beatty sequences against exact rationals, by substitution, by search, and of corner
// tiles over Wang tiles.
#include "tests/support/errors.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/beatty_tiling.hpp"
#include "tiles/aperiodic/constructed_tilings.hpp"
#include "tiles/aperiodic/tiling_search.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// The number of neighbours that do not fit.
template <class Place>
std::size_t mismatches(const WangList& list, const std::vector<Place>& tiles, std::size_t width)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const WangTile& tile = list.tiles.at(tiles[i]);
        if (i % width + 1 < width && tile.east != list.tiles.at(tiles[i + 1]).west) ++count;
        if (i + width < tiles.size() && tile.south != list.tiles.at(tiles[i + width]).north) ++count;
    }
    return count;
}

template <class Place>
std::size_t different_tiles(const std::vector<Place>& tiles)
{
    return std::set<Place>(tiles.begin(), tiles.end()).size();
}

/// The number that a FixedPoint stands for.
Rational value_of(const FixedPoint& number)
{
    const boost::multiprecision::cpp_int integer =
        (boost::multiprecision::cpp_int(number.high) << 64) + boost::multiprecision::cpp_int(number.low);
    return Rational(integer, boost::multiprecision::cpp_int(1) << 96);
}

boost::multiprecision::cpp_int floor_of(const Rational& x)
{
    const boost::multiprecision::cpp_int n = numerator(x), d = denominator(x);
    if (n >= 0) return n / d;
    return -((-n + d - 1) / d);
}

/// Kari's and Culik's rules in exact rationals, from alpha and beta of row 0 downwards: colours of each tile.
class RationalTwin
{
public:
    RationalTwin(BeattySet set, const BeattyRow& first)
        : is_kari_(set == BeattySet::kari), slope_(value_of(first.slope)), offset_(value_of(first.offset))
    {}

    /// The tiles x, ..., x + width - 1 of the next row.
    std::vector<WangTile> next_row(std::int64_t x, std::size_t width)
    {
        const bool is_first = slope_ <= (is_kari_ ? Rational(1) : Rational(2, 3));
        const Rational q = is_kari_   ? (is_first ? Rational(2) : Rational(2, 3))
                           : is_first ? Rational(3)
                                      : Rational(1, 2);
        const bool is_next_marked = !is_kari_ && q * slope_ > Rational(2, 3);
        std::vector<WangTile> tiles;
        for (std::int64_t i = x; i < x + static_cast<std::int64_t>(width); ++i) {
            const Rational here = slope_ * i + offset_, next = slope_ * (i + 1) + offset_;
            const auto carry = [&](const Rational& at) {
                return color_of(q * floor_of(at) - floor_of(q * at), is_first);
            };
            tiles.push_back({digit(floor_of(next) - floor_of(here), !is_kari_ && !is_first), carry(next),
                             digit(floor_of(q * next) - floor_of(q * here), is_next_marked), carry(here)});
        }
        slope_ *= q;
        offset_ *= q;
        return tiles;
    }

private:
    static Color digit(const boost::multiprecision::cpp_int& value, bool is_marked)
    {
        return value == 0 && is_marked ? 3 : static_cast<Color>(value);
    }

    /// The vertical colours of kari_tiles() and culik_tiles().
    Color color_of(const Rational& carry, bool is_first) const
    {
        const Rational color = is_kari_ ? Rational(is_first ? Rational(carry + 1) : Rational(3 * carry + 1 + 2))
                                        : Rational(is_first ? Rational(carry + 2) : Rational(2 * carry + 3));
        EXPECT_EQ(denominator(color), 1);
        return static_cast<Color>(numerator(color));
    }

    bool is_kari_;
    Rational slope_, offset_;
};

class BeattyTilings : public testing::TestWithParam<BeattySet>
{
protected:
    static WangList tiles() { return GetParam() == BeattySet::kari ? kari_tiles() : culik_tiles(); }
};

TEST_P(BeattyTilings, AreThoseOfExactRationals)
{
    constexpr std::size_t width = 200, height = 120;
    const BeattyTiling tiling(GetParam(), 5);
    RationalTwin twin(GetParam(), tiling.rows(0, 1)[0]);
    const auto made = reference::beatty_tiles(tiling, {-70, 1 - static_cast<std::int64_t>(height), width, height});
    const WangList list = tiles();
    for (std::size_t row = 0; row < height; ++row) {
        const auto expected = twin.next_row(-70, width);
        for (std::size_t column = 0; column < width; ++column)
            ASSERT_EQ(list.tiles[made[row * width + column]], expected[column]) << row << ", " << column;
    }
    EXPECT_EQ(different_tiles(made), list.tiles.size());
}

TEST_P(BeattyTilings, FitInAMillionTiles)
{
    const auto made = reference::beatty_tiles(BeattyTiling(GetParam(), 3), {-500, -500, 1000, 1000});
    EXPECT_EQ(mismatches(tiles(), made, 1000), 0U);
    EXPECT_EQ(different_tiles(made), tiles().tiles.size());
}

TEST_P(BeattyTilings, AreTheSameInAnyWindow)
{
    const BeattyTiling tiling(GetParam(), 9);
    const auto whole = reference::beatty_tiles(tiling, {-20, -30, 50, 60});
    const auto part = reference::beatty_tiles(tiling, {-3, -11, 7, 5});
    for (std::size_t row = 0; row < 5; ++row)
        for (std::size_t column = 0; column < 7; ++column)
            EXPECT_EQ(part[row * 7 + column], whole[(60 - 24 + row) * 50 + 17 + column]);
    EXPECT_NE(reference::beatty_tiles(BeattyTiling(GetParam(), 10), {-3, -11, 7, 5}), part);
}

TEST_P(BeattyTilings, RowsHaveTheRatioOfTheirMachine)
{
    // Far from row 0, where rows are found by logarithms: each is q times the one above, as far as it is rounded.
    const BeattyTiling tiling(GetParam(), 2);
    const bool is_kari = GetParam() == BeattySet::kari;
    for (const std::int64_t y : {1'000'000, 4000, 12, -3, -5000}) {
        const auto rows = tiling.rows(y, 30);
        for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
            const Rational q = is_kari                ? (rows[i].machine == 0 ? Rational(2) : Rational(2, 3))
                               : rows[i].machine == 0 ? Rational(3)
                                                      : Rational(1, 2);
            const Rational unit(1, boost::multiprecision::cpp_int(1) << 96);
            // Both are rounded by half a unit, of which the upper one is multiplied.
            EXPECT_LE(abs(value_of(rows[i].slope) * q - value_of(rows[i + 1].slope)), unit * (q + 1) / 2);
            EXPECT_LE(abs(value_of(rows[i].offset) * q - value_of(rows[i + 1].offset)), unit * (q + 1) / 2);
            EXPECT_GT(value_of(rows[i].slope), is_kari ? Rational(2, 3) : Rational(1, 3));
            EXPECT_LE(value_of(rows[i].slope), 2);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, BeattyTilings, testing::Values(BeattySet::kari, BeattySet::culik));

TEST(AmmannTiling, FitsAndHasAllTiles)
{
    for (const std::uint64_t seed : {1, 2, 3}) {
        const auto tiles = ammann_tiles_of({0, 0, 377, 233}, seed);
        EXPECT_EQ(mismatches(ammann_tiles(), tiles, 377), 0U);
        EXPECT_EQ(different_tiles(tiles), 16U);
    }
    const auto whole = ammann_tiles_of({0, 0, 100, 90}, 4);
    const auto part = ammann_tiles_of({40, 30, 7, 5}, 4);
    for (std::size_t row = 0; row < 5; ++row)
        for (std::size_t column = 0; column < 7; ++column)
            EXPECT_EQ(part[row * 7 + column], whole[(90 - 35 + row) * 100 + 40 + column]);
    EXPECT_EQ(message_of([] {
                  ammann_tiles_of({0, 0, 1, 1975}, 1);
              }),
              "columns and rows of a tiling by substitution are from -610 to 1973");
}

TEST(AmmannTiling, HasTheSquaresThatWereCounted)
{
    // Different squares of 1 to 5 tiles: 16, 51, 102, 173, 266.
    constexpr std::size_t side = 377;
    const auto tiles = ammann_tiles_of({0, 0, side, side}, 1);
    const std::array<std::size_t, 5> expected{16, 51, 102, 173, 266};
    for (std::size_t k = 1; k <= 5; ++k) {
        std::set<std::vector<ListPlace>> squares;
        for (std::size_t y = 0; y + k <= side; ++y)
            for (std::size_t x = 0; x + k <= side; ++x) {
                std::vector<ListPlace> square;
                for (std::size_t j = 0; j < k; ++j)
                    for (std::size_t i = 0; i < k; ++i) square.push_back(tiles[(y + j) * side + x + i]);
                squares.insert(std::move(square));
            }
        EXPECT_EQ(squares.size(), expected[k - 1]) << k;
    }
}

TEST(TilingSearch, FindsTilingsWithEverySet)
{
    for (const AperiodicSet& set : aperiodic_sets()) {
        if (set.tiles == nullptr) continue;
        const WangList list = set.tiles();
        const auto tiles = search_tiling(list, {16, 16, 1});
        ASSERT_TRUE(tiles) << set.name;
        EXPECT_EQ(tiles->size(), 256U);
        EXPECT_EQ(mismatches(list, *tiles, 16), 0U) << set.name;
        EXPECT_EQ(search_tiling(list, {16, 16, 1}), tiles) << set.name;
        EXPECT_NE(search_tiling(list, {16, 16, 2}), tiles) << set.name;
    }
}

TEST(TilingSearch, ProvesThatThereIsNone)
{
    // A row of two is all that fits.
    const WangList two{{{0, 1, 0, 0}, {0, 2, 0, 1}}, {1, 3}};
    bool proven = false;
    EXPECT_TRUE(search_tiling(two, {2, 5, 1}, &proven));
    EXPECT_FALSE(proven);
    EXPECT_FALSE(search_tiling(two, {3, 1, 1}, &proven));
    EXPECT_TRUE(proven);
    // A border that fits locally everywhere but not as a whole takes backtracking: odd columns of two colours, closed.
    const WangList odd{{{0, 0, 1, 0}, {1, 0, 2, 0}, {2, 0, 3, 0}}, {4, 1}};
    EXPECT_FALSE(search_tiling(odd, {4, 4, 1}, &proven));
    EXPECT_TRUE(proven);
    EXPECT_EQ(message_of([&] { search_tiling(two, {300, 300, 1}); }), "300 x 300 tiles: at most 65536 can be searched");
}

class CornerTilings : public testing::TestWithParam<CornerConstruction>
{
};

TEST_P(CornerTilings, LieOverTilingsOfWangTiles)
{
    // Kari's set: what lies over it fits, and is made of different windows of the same tiling.
    const WangList wang = kari_tiles();
    const BeattyTiling tiling(BeattySet::kari, 4);
    const WindowMaker make_window = [&](const TileWindow& window) {
        const auto tiles = reference::beatty_tiles(tiling, window);
        return std::vector<ListPlace>(tiles.begin(), tiles.end());
    };
    const CornerList corners = construct_corners(wang, GetParam()).list;
    const WangList list = wang_list_of(corners);
    const auto whole = corner_tiles_of(wang, corners, GetParam(), {-17, -9, 40, 30}, make_window);
    ASSERT_EQ(whole.size(), 1200U);
    EXPECT_EQ(mismatches(list, whole, 40), 0U);
    const auto part = corner_tiles_of(wang, corners, GetParam(), {-6, 2, 7, 5}, make_window);
    for (std::size_t row = 0; row < 5; ++row)
        for (std::size_t column = 0; column < 7; ++column)
            EXPECT_EQ(part[row * 7 + column], whole[(30 - 16 + row) * 40 + 11 + column]);
}

INSTANTIATE_TEST_SUITE_P(Constructions, CornerTilings,
                         testing::Values(CornerConstruction::diagonal, CornerConstruction::vertical,
                                         CornerConstruction::rotation, CornerConstruction::subdivision));

TEST(CornerTilingsOfHorizontalTiles, LieOverAmmannsTiling)
{
    const CornerList corners = construct_corners(ammann_tiles(), CornerConstruction::horizontal).list;
    const auto tiles = corner_tiles_of(ammann_tiles(), corners, CornerConstruction::horizontal, {-7, 3, 60, 50},
                                       [](const TileWindow& window) { return ammann_tiles_of(window, 1); });
    EXPECT_EQ(mismatches(wang_list_of(corners), tiles, 60), 0U);
}

}
}
