// Tile sets whose points have classes: brute force over all surroundings of tiles, the same tiles whoever makes them,
// and sets that were spoiled.
#include "host/tile_construction/classes/class_construction.hpp"

#include "tests/support/class_surroundings.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/small_tile_sets.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;

PoissonTileSet classes_by_device(const PoissonTileParameters& p, std::size_t work_group_size = 0, unsigned threads = 0)
{
    const auto filler = make_class_tile_filler(class_fill_settings(p), Device::open({}, threads), work_group_size);
    return construct_class_tiles(p, *filler).set;
}

const PoissonTileSet& two_classes()
{
    static const PoissonTileSet set = classes_by_device(class_parameters(2, {4, 9}, 0.5));
    return set;
}

TEST(ClassTilesExhaustively, TheProofIsWhatOccursInAllSurroundings)
{
    const PoissonTileSet& set = two_classes();
    const TileClasses& classes = set.parameters.classes;
    const std::vector<ClassPairProof> proofs = certify(set).classes;
    ASSERT_EQ(proofs.size(), 3U);
    for (const auto& [one, other] : {std::pair{0U, 0U}, {0U, 1U}, {1U, 1U}}) {
        const ClassPairProof& proof = proofs[class_pair(one, other)];
        const std::uint64_t least = least_in_all_surroundings(set, one, other);
        EXPECT_EQ(least, least_in_all_surroundings(set, other, one));
        EXPECT_GE(least, proof.squared_min_distance);
        if (proof.squared_closure_distance <= proof.squared_separation) {
            EXPECT_EQ(least, proof.squared_min_distance) << one << " " << other;
        }
        const double asked = classes.distances.at(one, other) * 65536;
        EXPECT_GE(std::sqrt(static_cast<double>(least)), asked * (1 - 1e-12));
    }
}

/// Wei 2010, section 3.2, by hand: the densest packing of n points on the unit torus has the distance
/// sqrt(2 / (sqrt 3 n)), and densities 1 / distance^2 add up.
TEST(ClassTiles, AskForTheDistancesOfWei)
{
    const TileClasses classes = class_parameters(2, {4, 9}, 0.5).classes;
    const auto packed = [](double n) { return std::sqrt(2 / (std::numbers::sqrt3 * n)); };
    EXPECT_NEAR(classes.distances.at(0, 0), 0.5 * packed(4), 1e-12);
    EXPECT_NEAR(classes.distances.at(1, 1), 0.5 * packed(9), 1e-12);
    EXPECT_NEAR(classes.distances.at(0, 1), 0.5 * packed(13), 1e-12);
}

TEST(ClassTiles, PointsKnowTheirClassByTheirPlace)
{
    const TileClasses classes = class_parameters(2, {4, 9, 1}, 0.4).classes;
    EXPECT_EQ(classes.first_point(2), 13U);
    std::vector<std::uint32_t> counts(3);
    for (std::uint32_t point = 0; point < classes.all_points(); ++point) ++counts[classes.class_of(point)];
    EXPECT_EQ(counts, classes.points);
    EXPECT_EQ(classes.class_of(3), 0U);
    EXPECT_EQ(classes.class_of(4), 1U);
    EXPECT_EQ(classes.class_of(13), 2U);
}

TEST(ClassTilesDeterminism, AnyWorkGroupSizeAndTheReferenceMakeTheSameTiles)
{
    const PoissonTileParameters& p = two_classes().parameters;
    EXPECT_EQ(classes_by_device(p, 7), two_classes());
    EXPECT_EQ(classes_by_device(p, 64, 1), two_classes());
    const auto filler = reference::make_class_tile_filler(class_fill_settings(p));
    EXPECT_EQ(construct_class_tiles(p, *filler).set, two_classes());
    PoissonTileParameters other = p;
    ++other.seed;
    EXPECT_NE(classes_by_device(other).points, two_classes().points);
}

/// A case in which darts find no room at once, and points are pushed.
TEST(ClassFilling, TheKernelMakesWhatTheReferenceMakes)
{
    const PoissonTileParameters p = class_parameters(1, {6, 10, 24}, 0.72);
    const ClassFillSettings settings = class_fill_settings(p);
    FillStage stage{.regions = regions_of(p), .number = 3};
    stage.active.cells = all_cells(2);
    const ClassFillProblem problem{
        .held = {{{0, 0, 0}}, {{65536, 65536, 0}}, {{65536, 0, 0}}}, .active = {23, 39, 95}, .stream = 4};
    const auto plain = reference::make_class_tile_filler(settings)->fill(stage, std::span(&problem, 1), 5);
    EXPECT_GT(plain.front().part, whole_part / 4);
    for (const std::size_t group : {0, 3, 32})
        EXPECT_EQ(make_class_tile_filler(settings, Device::open({}), group)->fill(stage, std::span(&problem, 1), 5),
                  plain);
}

// Sets that were spoiled.

std::string refusal(const PoissonTileSet& set)
{
    return refusal_of(
        [&] { check_class_promises(set.parameters.classes, set.class_squared_distances, certify(set).classes); });
}

PoissonTileSet spoiled(const std::function<void(PoissonTileSet&)>& change)
{
    PoissonTileSet set = two_classes();
    change(set);
    return set;
}

/// The number of the first coordinate of a point of a class of tile 5 that is nearest to the middle of the tile, so
/// that no other tile shares it.
std::size_t middle_point(const PoissonTileSet& set, std::uint32_t of)
{
    const TileClasses& classes = set.parameters.classes;
    const std::uint32_t first = classes.first_point(of);
    std::uint32_t best = first;
    const auto off = [&](std::uint32_t point) {
        const UnitPosition at = set.position(5, point);
        return std::max(std::abs(at[0] - 32768), std::abs(at[1] - 32768));
    };
    for (std::uint32_t point = first; point < first + classes.points[of]; ++point)
        if (off(point) < off(best)) best = point;
    return std::size_t{2} * (5 * set.parameters.points_per_tile + best);
}

TEST(SpoiledClassTiles, AreRefused)
{
    EXPECT_EQ(refusal(two_classes()), "accepted");
    const auto nearer = spoiled([](PoissonTileSet& set) {
        const std::size_t coarse = middle_point(set, 0), fine = middle_point(set, 1);
        set.points[fine] = static_cast<std::uint16_t>(set.points[coarse] + 100);
        set.points[fine + 1] = set.points[coarse + 1];
    });
    EXPECT_THAT(refusal(nearer), HasSubstr("must be at most 10000, which is proven"));
    EXPECT_THAT(refusal(nearer), HasSubstr("of tile 5"));
    const auto promised = spoiled(
        [](PoissonTileSet& set) { set.class_squared_distances[1] = certify(set).classes[1].squared_min_distance + 1; });
    EXPECT_THAT(refusal(promised), HasSubstr("classes 0 and 1: promises a squared distance of"));
}

/// A point that tiles share has another class in one of them: all points together are as they were.
TEST(SpoiledClassTiles, MustAgreeOnClasses)
{
    const auto exchanged = spoiled([](PoissonTileSet& set) {
        const TileClasses& classes = set.parameters.classes;
        const TileRegions regions = regions_of(set.parameters);
        const auto is_shared = [&](std::uint32_t point) {
            return regions.cell_of(set.tile(5).subspan(std::size_t{2} * point, 2)).axes != 3;
        };
        const std::size_t first = std::size_t{2} * 5 * set.parameters.points_per_tile;
        for (std::uint32_t a = 0; a < classes.points[0]; ++a)
            for (std::uint32_t b = classes.points[0]; b < classes.all_points(); ++b)
                if (is_shared(a) || is_shared(b)) {
                    std::swap(set.points[first + 2 * a], set.points[first + 2 * b]);
                    std::swap(set.points[first + 2 * a + 1], set.points[first + 2 * b + 1]);
                    return;
                }
    });
    EXPECT_THAT(refusal(exchanged), HasSubstr("class 0: tile "));
}

TEST(ClassTiles, SayWhichDistancesHaveNoRoom)
{
    const PoissonTileParameters p = class_parameters(1, {4, 12}, 0.53);
    const auto room = refusal_of([&] { check(class_parameters(2, {2, 20}, 0.62)); });
    EXPECT_THAT(room, HasSubstr("points of classes that keep a distance of 0.4711 tiles: must be at most 0.2928"));
    const PoissonTileParameters dense = class_parameters(1, {12, 12}, 0.9);
    const auto filler = make_class_tile_filler(class_fill_settings(dense), Device::open({}));
    EXPECT_THAT(refusal_of([&] { construct_class_tiles(dense, *filler); }),
                HasSubstr("tiles with 12, 12 points of classes: one of the edges (number 0)"));
    EXPECT_EQ(refusal_of([&] { check(p); }), "accepted");
}

}
}
