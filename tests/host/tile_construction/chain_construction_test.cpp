// Tile sets with chains: the minimum distance as proven and as seen, the same tiles whoever makes them, and what joint
// relaxation and nulling are for.
#include "host/tile_construction/chain_construction.hpp"

#include "host/tile_construction/chain_paths.hpp"
#include "tests/support/cgal_distance.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/mean_tile.hpp"
#include "tests/support/small_tile_sets.hpp"
#include "tests/tiles/poisson/made_up_tilings.hpp"
#include "tiles/poisson/chain_geometry.hpp"
#include "tiles/poisson/chain_pieces.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <utility>

namespace poissonlab {
namespace {

using testing::HasSubstr;

PoissonTileParameters chain_parameters(std::uint32_t colors, std::uint32_t points, double radius,
                                       std::uint32_t joint_iterations = 8, bool null_peaks = true)
{
    PoissonTileParameters p = tile_set_parameters(PoissonTileKind::corner, 2, colors, points, radius);
    p.lloyd_iterations = 10;
    set_border(p, TileBorder::chain, joint_iterations, null_peaks);
    return p;
}

PoissonTileParameters template_chain_parameters(std::uint32_t tiles)
{
    PoissonTileParameters p = tile_set_parameters(PoissonTileKind::frame, 2, tiles, 32, 0.75);
    p.lloyd_iterations = 10;
    set_border(p, TileBorder::chain, 8);
    return p;
}

PoissonTileSet chains_by_device(const PoissonTileParameters& p, std::size_t work_group_size = 0, unsigned threads = 0)
{
    const Device device = Device::open({}, threads);
    const auto tori = make_tile_filler(chain_torus_settings(p), device, work_group_size);
    const auto interiors = make_tile_filler(chain_interior_settings(p), device, work_group_size);
    const auto joint = make_joint_engine(2, device, work_group_size);
    return construct_chain_tiles(p, {*tori, *interiors, *joint}).set;
}

PoissonTileSet chains_by_reference(const PoissonTileParameters& p)
{
    const auto tori = reference::make_tile_filler(chain_torus_settings(p));
    const auto interiors = reference::make_tile_filler(chain_interior_settings(p));
    const auto joint = reference::make_joint_engine(2);
    return construct_chain_tiles(p, {*tori, *interiors, *joint}).set;
}

const PoissonTileSet& three_colors()
{
    static const PoissonTileSet set = chains_by_device(chain_parameters(3, 32, 0.75));
    return set;
}

class ChainTiles : public testing::TestWithParam<SmallSet>
{
};

TEST_P(ChainTiles, EveryTilingKeepsTheDistance)
{
    const PoissonTileParameters& p = GetParam().parameters;
    const PoissonTileSet set = chains_by_device(p);
    const TileCertificate proof = certify(set);
    EXPECT_GE(proof.squared_min_distance, asked_squared_distance(p));
    const MadeUpTiling tiling(p, 100, 5);
    std::vector<TestPosition> points;
    for (int j = 0; j < 100; ++j)
        for (int i = 0; i < 100; ++i) tiling.append(set, i, j, 0, points);
    EXPECT_GE(squared_distance_by_cgal(points), static_cast<double>(proof.squared_min_distance));
}

INSTANTIATE_TEST_SUITE_P(Sets, ChainTiles,
                         testing::Values(SmallSet{"three_colors", chain_parameters(3, 32, 0.75)},
                                         SmallSet{"without_joint_iterations", chain_parameters(2, 32, 0.75, 0, false)},
                                         SmallSet{"dense", chain_parameters(2, 64, 0.85)},
                                         SmallSet{"few_points", chain_parameters(2, 8, 0.7)},
                                         SmallSet{"one_color", chain_parameters(1, 100, 0.8)},
                                         SmallSet{"template", template_chain_parameters(9)}),
                         [](const auto& sets) { return sets.param.name; });

/// Each of the 2^16 surroundings that a tile of two colours can have: 3 x 3 tiles by 16 corners.
TEST(ChainTilesExhaustively, NoSurroundingsBreakTheDistance)
{
    const PoissonTileParameters p = chain_parameters(2, 12, 0.75, 4);
    const PoissonTileSet set = chains_by_device(p);
    const auto wanted = static_cast<std::int64_t>(certify(set).squared_min_distance);
    EXPECT_GE(static_cast<std::uint64_t>(wanted), asked_squared_distance(p));
    std::int64_t least = INT64_MAX;
    std::vector<TestPosition> middle, around;
    for (unsigned colors = 0; colors < 1u << 16; ++colors) {
        const auto color = [&](unsigned x, unsigned y) { return colors >> (4 * y + x) & 1; };
        middle.clear();
        around.clear();
        for (unsigned y = 0; y < 3; ++y)
            for (unsigned x = 0; x < 3; ++x) {
                const std::uint32_t tile =
                    corner_tile_of({color(x, y), color(x + 1, y), color(x, y + 1), color(x + 1, y + 1)}, 2, p.colors);
                for (std::uint32_t i = 0; i < p.points_per_tile; ++i) {
                    const UnitPosition point = set.position(tile, i);
                    const TestPosition at{point[0] + std::int64_t{x} * tile_units,
                                          point[1] + std::int64_t{y} * tile_units, 0};
                    (x == 1 && y == 1 ? middle : around).push_back(at);
                }
            }
        for (std::size_t i = 0; i < middle.size(); ++i) {
            for (std::size_t j = i + 1; j < middle.size(); ++j)
                least = std::min(least, squared_distance(middle[i], middle[j]));
            for (const TestPosition& other : around) least = std::min(least, squared_distance(middle[i], other));
        }
    }
    EXPECT_GE(least, wanted);
}

TEST(ChainTilesDeterminism, AnyWorkGroupSizeAndNumberOfThreadsMakeTheSameTiles)
{
    EXPECT_EQ(chains_by_device(three_colors().parameters, 7), three_colors());
    EXPECT_EQ(chains_by_device(three_colors().parameters, 64), three_colors());
    EXPECT_EQ(chains_by_device(three_colors().parameters, 0, 1), three_colors());
}

TEST(ChainTilesDeterminism, TheReferenceMakesTheSameTiles)
{
    for (const PoissonTileParameters& p : {chain_parameters(2, 32, 0.75), template_chain_parameters(4)})
        EXPECT_EQ(chains_by_reference(p), chains_by_device(p));
}

TEST(ChainTilesDeterminism, SeedsMakeOtherTiles)
{
    PoissonTileParameters p = chain_parameters(2, 32, 0.75);
    const PoissonTileSet one = chains_by_device(p);
    ++p.seed;
    EXPECT_NE(chains_by_device(p).points, one.points);
}

// The certificate.

PoissonTileSet changed_set(const std::function<void(ChainPieces&)>& change)
{
    ChainPieces pieces = chain_pieces_of(three_colors());
    change(pieces);
    return tile_set_of(pieces, three_colors().parameters);
}

std::string refusal_after(const std::function<void(ChainPieces&)>& change)
{
    return refusal_of([&] { certify(changed_set(change)); });
}

TEST(ChainCertificate, ReadsThePiecesThatWereStored)
{
    EXPECT_EQ(changed_set([](ChainPieces&) {}), three_colors());
    EXPECT_EQ(refusal_after([](ChainPieces&) {}), "accepted");
}

TEST(ChainCertificate, RefusesWhatTheTheoremDoesNotHoldFor)
{
    EXPECT_THAT(refusal_after([](ChainPieces& p) {
                    Chain& chain = p.chains[0][4]; // one link over two
                    const UnitPosition gone = chain[2];
                    chain.erase(chain.begin() + 2);
                    for (std::uint32_t tile = 0; tile < 81; ++tile) // as many points as before
                        if (chains_around(tile, 3).front().number(3) == 4) p.interiors[tile].push_back(gone);
                }),
                HasSubstr("chain to the right from colour 1 to 1: link from "));
    EXPECT_THAT(refusal_after([](ChainPieces& p) { p.interiors[5].front()[0] -= tile_units / 2; }),
                HasSubstr("tile 5: its point at "));
    EXPECT_THAT(refusal_after([](ChainPieces& p) { p.chains[0][3][2][1] += 80000; }),
                HasSubstr("its border must not cross itself"));
}

TEST(ChainCertificate, RefusesLinksThatAreTooLong)
{
    // A point less on a chain, and one more inside of all tiles that own it, far from the chain.
    const std::string message = refusal_after([](ChainPieces& p) {
        Chain& chain = p.chains[1][8];
        chain.erase(chain.begin() + 2);
        for (std::uint32_t tile = 0; tile < 81; ++tile) {
            if (chains_around(tile, 3).back().number(3) != 8) continue;
            const std::vector<UnitPosition>& inside = p.interiors[tile];
            UnitPosition best{};
            std::int64_t most = -1;
            for (std::int32_t y = 20000; y < 50000; y += 500)
                for (std::int32_t x = 20000; x < 50000; x += 500) {
                    std::int64_t nearest = INT64_MAX;
                    for (const UnitPosition& point : inside)
                        nearest = std::min(nearest, squared_length(point, {x, y, 0}));
                    if (nearest > most) most = nearest, best = {x, y, 0};
                }
            p.interiors[tile].push_back(best);
        }
    });
    EXPECT_THAT(message, HasSubstr("link from "));
}

/// A point inside of a tile that came a little nearer to another one than was asked for, or only than was proven
/// before: its own tile is named, and no link of a chain, which may be too long for the smaller distance.
TEST(ChainCertificate, NamesTheTileWhosePointsAreTooNear)
{
    const TileCertificate whole = certify(three_colors());
    const std::uint64_t asked = asked_squared_distance(three_colors().parameters);
    for (const std::uint64_t wanted : {asked, whole.squared_min_distance}) {
        constexpr std::uint32_t tile = 23;
        PoissonTileSet set = changed_set([&](ChainPieces& p) {
            UnitPosition& moved = p.interiors[tile].front();
            const UnitPosition at = p.interiors[tile].back();
            // One point is moved to the other point's right, at the largest even distance that is too small.
            const auto distance = static_cast<std::int32_t>(std::sqrt(static_cast<double>(wanted))) / 2 * 2 - 2;
            moved = {at[0] + distance, at[1], 0};
        });
        set.squared_min_distance = whole.squared_min_distance;
        const std::string message =
            refusal_of([&] { check_promises(set.parameters, set.squared_min_distance, certify(set)); });
        EXPECT_THAT(message, testing::AnyOf(HasSubstr("of tile 23"), testing::StartsWith("tile 23: "))) << wanted;
        EXPECT_THAT(message, testing::Not(HasSubstr("link")));
    }
}

TEST(ChainCertificate, RefusesTilesThatDifferInWhatTheyShare)
{
    PoissonTileSet set = three_colors();
    ++set.points[2 * 32 * 40]; // of tile 40
    EXPECT_THAT(refusal_of([&] { certify(set); }), HasSubstr("tile 40: its corner point differs from tile "));
    set = three_colors();
    set.points[2 * (32 * 50 + 2)] += 2;
    EXPECT_THAT(refusal_of([&] { certify(set); }), HasSubstr("tile 50: its lower chain differs from tile "));
    set = three_colors();
    set.chain_lengths[0] = 40;
    EXPECT_THAT(refusal_of([&] { certify(set); }), HasSubstr("must leave one of 32 for its corner"));
    set.chain_lengths.pop_back();
    EXPECT_THAT(refusal_of([&] { certify(set); }), HasSubstr("lengths of chains: must be 18"));
}

TEST(ChainCertificate, SaysWhatDistanceThereIs)
{
    // Where two points inside of a tile are closer together, links are too long for what distance is left: the points
    // are what is wrong.
    const std::string message = refusal_after([](ChainPieces& p) {
        const UnitPosition a = p.interiors[7][3];
        p.interiors[7][4] = {a[0] + 2000, a[1], 0};
    });
    EXPECT_THAT(message, testing::MatchesRegex("the points at .* and .* of tile 7 are 2000.0 units apart: must be at "
                                               "least 9336.9, the distance of the set's relative radius"));
}

// Equal moments.

PoissonTileParameters even_parameters(std::uint32_t order, std::uint32_t colors = 2, double radius = 0.75)
{
    PoissonTileParameters p = chain_parameters(colors, 32, radius);
    p.equal_moments = order;
    return p;
}

TEST(ChainMoments, AreEqualInWholeNumbersAndCostNoDistance)
{
    for (const std::uint32_t order : {1, 2}) {
        const PoissonTileSet set = chains_by_device(even_parameters(order, 3));
        const TileCertificate proof = certify(set);
        EXPECT_GE(proof.squared_min_distance, asked_squared_distance(set.parameters));
        EXPECT_EQ(proof.moments.equal_order(), order);
        EXPECT_EQ(proof.moments.proven_exponent(), 2 * order + 2);
        EXPECT_EQ(refusal_of([&] { check_promises(set.parameters, proof.squared_min_distance, proof); }), "accepted");
    }
}

/// The points of a random tiling on a torus of so many tiles, in tiles.
std::vector<std::array<double, 2>> points_of_tiling(const PoissonTileSet& set, int side)
{
    const std::uint32_t colors = set.parameters.colors;
    std::mt19937 random(7);
    std::vector<std::uint32_t> corner(static_cast<std::size_t>(side * side));
    for (std::uint32_t& color : corner) color = static_cast<std::uint32_t>(random() % colors);
    const auto color = [&](int x, int y) { return corner[static_cast<std::size_t>(y % side * side + x % side)]; };
    std::vector<std::array<double, 2>> points;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::uint32_t tile =
                corner_tile_of({color(x, y), color(x + 1, y), color(x, y + 1), color(x + 1, y + 1)}, 2, colors);
            for (std::uint32_t i = 0; i < set.parameters.points_per_tile; ++i) {
                const UnitPosition at = set.position(tile, i);
                points.push_back({x + double{1} * at[0] / tile_units, y + double{1} * at[1] / tile_units});
            }
        }
    return points;
}

/// The mean power of such a tiling at frequencies from `low` to `high` cycles a tile, off the tiles' lattice, by its
/// definition.
double mean_power(const PoissonTileSet& set, int side, double low, double high)
{
    const auto points = points_of_tiling(set, side);
    const int most = static_cast<int>(high * side);
    const auto wave = [&](int n, double x) { return std::polar(1.0, -2 * std::numbers::pi * n * x / side); };
    double sum = 0;
    int count = 0;
    for (int b = 0; b <= most; ++b) {
        std::vector<std::complex<double>> transforms(static_cast<std::size_t>(2 * most + 1));
        for (const auto& [x, y] : points) {
            const std::complex<double> step = wave(1, x);
            std::complex<double> term = wave(b, y) * wave(-most, x);
            for (auto& transform : transforms) transform += std::exchange(term, term * step);
        }
        for (int a = -most; a <= most; ++a) {
            const double length = std::hypot(a, b) / side;
            if (length < low || length > high || (a % side == 0 && b % side == 0)) continue;
            sum += std::norm(transforms[static_cast<std::size_t>(a + most)]) / static_cast<double>(points.size());
            ++count;
        }
    }
    return sum / count;
}

/// Three colours with all joint iterations.
PoissonTileSet relaxed_set(std::uint32_t equal_moments)
{
    PoissonTileParameters p = even_parameters(equal_moments, 3);
    set_border(p, TileBorder::chain, {}, {}, equal_moments);
    return chains_by_device(p);
}

const PoissonTileSet& even_three_colors()
{
    static const PoissonTileSet set = relaxed_set(2);
    return set;
}

/// A set without equal moments has 5e-4 and 4e-3 there.
TEST(ChainMoments, TakeThePowerOutOfLowFrequencies)
{
    EXPECT_LT(mean_power(even_three_colors(), 48, 0.08, 0.09), 1e-6);
    EXPECT_LT(mean_power(even_three_colors(), 48, 0.245, 0.255), 2e-4);
}

/// The mean of 1,700 powers, each of which varies by itself, varies by a fortieth. Such sets have 0.0175, and 0.0225
/// where transforms of tiles are free to change in their own ways; sets without equal moments have from 0.013 to 0.016.
TEST(ChainMoments, HardlyAddPowerBetweenThePeaks) { EXPECT_LT(mean_power(even_three_colors(), 24, 0.6, 1.5), 0.0195); }

TEST(ChainMoments, LeavePeaksOfTheLatticeNoHigher)
{
    const PoissonTileSet without = relaxed_set(0);
    const double root = std::sqrt(32);
    for (const auto& [low, high] : {std::pair{0.1, 1.1}, std::pair{1.1, 1.4}, std::pair{1.4, 2.0}})
        EXPECT_LE(power_of_mean_tile(even_three_colors(), low * root, high * root),
                  power_of_mean_tile(without, low * root, high * root))
            << low;
}

TEST(ChainMoments, OfTemplateTilesAreEqual)
{
    PoissonTileParameters p = template_chain_parameters(9);
    p.equal_moments = 2;
    EXPECT_EQ(certify(chains_by_device(p)).moments.equal_order(), 2U);
}

TEST(ChainMoments, AreBrokenByAUnit)
{
    PoissonTileSet set = chains_by_device(even_parameters(2));
    set.points[2 * (32 * 9 + 30)] += 1; // a point inside of tile 9
    const TileCertificate proof = certify(set);
    EXPECT_THAT(refusal_of([&] { check_promises(set.parameters, 0, proof); }),
                HasSubstr("equal_moments = 2: must be at most 0: first moments of tile "));
}

TEST(ChainMoments, DoNotDependOnWhoMakesThem)
{
    const PoissonTileSet set = chains_by_device(even_parameters(2));
    EXPECT_EQ(chains_by_reference(set.parameters), set);
    EXPECT_EQ(chains_by_device(set.parameters, 7), set);
    EXPECT_EQ(chains_by_device(set.parameters, 0, 1), set);
}

/// A tile of this set can have equal moments neither with its chains nor with those that it was filled with before.
TEST(ChainMoments, AreMadePossibleByOtherChains)
{
    PoissonTileParameters p = tile_set_parameters(PoissonTileKind::corner, 2, 2, 24, 0.84);
    set_border(p, TileBorder::chain, {}, {}, 2);
    p.seed = 5;
    EXPECT_EQ(certify(chains_by_device(p)).moments.equal_order(), 2U);
}

TEST(ChainMoments, ThatCannotBeHadAreRefusedWithThoseThatCan)
{
    PoissonTileParameters p = chain_parameters(2, 12, 0.7);
    p.equal_moments = 2;
    EXPECT_THAT(refusal_of([&] { chains_by_device(p); }),
                HasSubstr("equal_moments = 2: must be at most 1 with these parameters: "));
    p.equal_moments = 1;
    EXPECT_EQ(certify(chains_by_device(p)).moments.equal_order(), 1U);
}

// The gain of chains.

TEST(JointRelaxation, NullingTakesThePowerOutOfTheMeanTile)
{
    // A prototype had 0.055 of what strips have, and 0.63 without relaxation: with chains 0.0029 to 0.004.
    const double without = power_of_mean_tile(chains_by_device(chain_parameters(3, 32, 0.75, 0, false)));
    const double with = power_of_mean_tile(chains_by_device(chain_parameters(3, 32, 0.75, 20)));
    EXPECT_LT(with, 0.01);
    EXPECT_LT(with, 0.2 * without);
}

/// The area of a tile is its share and what its four chains leave it.
TEST(ChainBalance, AddsUpToAreas)
{
    const ChainPieces pieces = chain_pieces_of(three_colors());
    for (std::uint32_t tile = 0; tile < 81; ++tile) {
        const auto chains = chains_around(tile, 3);
        const auto area_of = [&](std::size_t side) {
            const PlacedChain& c = chains[side];
            const double n = static_cast<double>(pieces.chains[c.direction][c.number(3)].size());
            return (chain_balance(pieces, c.direction, c.lower, c.upper, 32) + 0.5 * n) / 32;
        };
        const double area = static_cast<double>(twice_area(border_polygon(pieces, tile))) / 2 / tile_units / tile_units;
        EXPECT_NEAR(area, 1 + area_of(2) - area_of(0) + area_of(1) - area_of(3), 1e-12);
    }
}

TEST(ChainTilesErrors, SayWhatIsAllowed)
{
    const auto refusal = [](const PoissonTileParameters& p) { return refusal_of([&] { check(p); }); };
    PoissonTileParameters p = chain_parameters(2, 32, 0.75);
    EXPECT_EQ(refusal(p), "accepted");
    p.repulsion = false;
    EXPECT_THAT(refusal(p), HasSubstr("repulsion = false: must be true for tiles with chains"));
    p = tile_set_parameters(PoissonTileKind::edge, 2, 2, 32, 0.75);
    set_border(p, TileBorder::chain);
    EXPECT_THAT(refusal(p), HasSubstr("border = chain: must be \"strip\" for edge tiles"));
    EXPECT_THAT(refusal_of([] { chains_by_device(chain_parameters(2, 16, 0.4, 0, false)); }),
                HasSubstr("relative_radius = 0.4: no chain from colour"));
}

}
}
