// The automaton of neighbourhoods, against tilings whose tiles are compared one with every other.
#include "tiles/polyominoes/neighbourhoods.hpp"

#include "tiles/polyominoes/polyomino_table.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace poissonlab {
namespace {

class PolyominoNeighbourhoods : public ::testing::TestWithParam<Polyomino>
{
protected:
    static const Neighbourhoods& all()
    {
        static std::map<Polyomino, Neighbourhoods> made;
        const auto found = made.find(GetParam());
        if (found != made.end()) return found->second;
        return made.emplace(GetParam(), neighbourhoods_of(division_rule(GetParam()))).first->second;
    }

    /// The least number of steps of a king from a cell of one tile to a cell of the other.
    static std::int64_t steps_between(const Pose& a, const Pose& b)
    {
        std::int64_t least = 1'000'000;
        for (const LatticePlace& cell : cells_of(GetParam()))
            for (const LatticePlace& other : cells_of(GetParam())) {
                const LatticePlace d = moved_cell(b, other) - moved_cell(a, cell);
                least = std::min(least, std::max(std::abs(d.x), std::abs(d.y)));
            }
        return least;
    }

    /// A tile's copies all over the plane, as far as they can be near it on a torus.
    static std::vector<Pose> copies_near(const Pose& tile, const Pose& other, std::int64_t period)
    {
        std::vector<Pose> copies;
        for (std::int64_t y = -2; y <= 2; ++y)
            for (std::int64_t x = -2; x <= 2; ++x) {
                const Pose copy{other.shift + LatticePlace{period * x, period * y}, other.turn};
                const LatticePlace d = copy.shift - tile.shift;
                if (copy != tile && std::abs(d.x) <= 9 && std::abs(d.y) <= 9) copies.push_back(copy);
            }
        return copies;
    }
};

INSTANTIATE_TEST_SUITE_P(Shapes, PolyominoNeighbourhoods, ::testing::Values(Polyomino::P, Polyomino::G),
                         [](const auto& shape) { return polyominoes[shape.param]; });

/// Random tori at the first level that the automaton knows: collars and near pairs are there, all of them, and those of
/// their children are what it says.
TEST_P(PolyominoNeighbourhoods, AreThoseOfRandomTori)
{
    const auto cells = static_cast<std::int64_t>(cells_of(GetParam()).size());
    for (std::uint32_t realization = 0; realization < 2; ++realization) {
        const auto roots = random_torus_tiling(GetParam(), cells, 3, realization);
        const std::vector<Pose> tiles = divided(all().rule, roots, all().first_level);
        std::int64_t period = cells;
        for (std::uint32_t i = 0; i < all().first_level; ++i) period *= all().rule.factor;
        const std::vector<Collar> collars = collars_on_torus(GetParam(), tiles, period);
        std::vector<std::uint32_t> classes;
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            std::set<Pose> touching;
            for (const Pose& other : tiles)
                for (const Pose& copy : copies_near(tiles[i], other, period))
                    if (steps_between(tiles[i], copy) <= 1) touching.insert(seen_from(tiles[i], copy));
            ASSERT_EQ(collars[i], Collar(touching.begin(), touching.end()));
            classes.push_back(class_of(all(), collars[i]));
            ASSERT_LT(classes.back(), all().collars.size());
        }
        for (std::size_t i = 0; i < tiles.size(); ++i)
            for (std::size_t j = 0; j < tiles.size(); ++j)
                for (const Pose& copy : copies_near(tiles[i], tiles[j], period)) {
                    const Pose seen = seen_from(tiles[i], copy);
                    const bool is_listed =
                        std::ranges::binary_search(all().pairs, NearTiles{classes[i], classes[j], seen});
                    const bool near = steps_between(tiles[i], copy) <= 2;
                    ASSERT_TRUE(is_listed || !near);
                    EXPECT_EQ(is_near(GetParam(), seen), near);
                }
        const std::vector<Pose> children = divided(all().rule, tiles, 1);
        const auto later = collars_on_torus(GetParam(), children, period * all().rule.factor);
        const std::size_t count = all().rule.children.size();
        for (std::size_t i = 0; i < children.size(); i += GetParam() == Polyomino::P ? 1 : 7)
            ASSERT_EQ(class_of(all(), later[i]), all().child_class(classes[i / count], i % count));
    }
}

/// The P pentomino's numbers are known: 53 classes of the tiling that grows from one tile, and 5 that other beginnings
/// leave along their borders.
TEST(PolyominoClasses, AreCounted)
{
    const Neighbourhoods all = neighbourhoods_of(division_rule(Polyomino::P));
    EXPECT_EQ(all.collars.size(), 58U);
    std::vector<Pose> tiles{Pose{}};
    tiles = divided(all.rule, tiles, 7);
    std::set<Collar> met;
    for (const Collar& collar : collars_within(Polyomino::P, tiles))
        if (!collar.empty()) met.insert(collar);
    EXPECT_EQ(met.size(), 53U);
    for (const Collar& collar : met) EXPECT_LT(class_of(all, collar), all.collars.size());
}

/// Frequencies of classes are those in a large division, which the automaton has no part in.
TEST(PolyominoClasses, OccurAsOftenAsTheirFrequenciesSay)
{
    const Neighbourhoods all = neighbourhoods_of(division_rule(Polyomino::P));
    const std::vector<double> frequencies = frequencies_of(all);
    const std::vector<Pose> tiles = divided(all.rule, random_torus_tiling(Polyomino::P, 10, 1, 0), 5);
    std::vector<double> counted(all.collars.size());
    for (const Collar& collar : collars_on_torus(Polyomino::P, tiles, 320)) ++counted[class_of(all, collar)];
    double total = 0;
    for (std::size_t i = 0; i < counted.size(); ++i) {
        // The pairs along the border of the first tiles halve with each division, which is where the two differ.
        EXPECT_NEAR(counted[i] / static_cast<double>(tiles.size()), frequencies[i], 0.02);
        total += frequencies[i];
    }
    EXPECT_NEAR(total, 1, 1e-3);
}

/// Figures around a corner: the four cells belong to tiles that do not overlap, each figure is there once, and every
/// corner of a random tiling has one.
TEST_P(PolyominoNeighbourhoods, BeginWithAllFiguresAroundACorner)
{
    const auto figures = corner_figures(GetParam());
    const std::set<std::vector<Pose>> listed(figures.begin(), figures.end());
    EXPECT_EQ(listed.size(), figures.size());
    const auto cells = static_cast<std::int64_t>(cells_of(GetParam()).size());
    const auto tiles = random_torus_tiling(GetParam(), 2 * cells, 5, 1);
    for (std::int64_t y = 0; y < 2 * cells; ++y)
        for (std::int64_t x = 0; x < 2 * cells; ++x) {
            std::set<Pose> around;
            for (const Pose& tile : tiles)
                for (std::int64_t v = -1; v <= 1; ++v)
                    for (std::int64_t u = -1; u <= 1; ++u) {
                        const Pose moved{tile.shift + 2 * cells * LatticePlace{u, v} - LatticePlace{x, y}, tile.turn};
                        for (const LatticePlace& cell : cells_of(GetParam())) {
                            const LatticePlace at = moved_cell(moved, cell);
                            if (at.x >= -1 && at.x <= 0 && at.y >= -1 && at.y <= 0) around.insert(moved);
                        }
                    }
            int found = 0;
            std::set<std::vector<Pose>> turned_figures;
            for (Turn turn = 0; turn < turns; ++turn) {
                std::vector<Pose> figure;
                for (const Pose& tile : around) figure.push_back(composed(Pose{{}, turn}, tile));
                std::ranges::sort(figure);
                turned_figures.insert(figure);
            }
            for (const auto& figure : turned_figures) found += listed.contains(figure);
            ASSERT_EQ(found, 1);
        }
}

}
}
