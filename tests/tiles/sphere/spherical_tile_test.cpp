// Tiles of the sphere are held against closed forms, solid angles of triangles, and windings around places.
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/errors.hpp"
#include "tiles/sphere/spherical_tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;
using SphereGroups = std::vector<std::pair<SphericalTileSettings, std::size_t>>;

/// All groups, and their orders: Conway, Burgiel, Goodman-Strauss, The Symmetries of Things, table 4.1.
SphereGroups sphere_groups()
{
    SphereGroups all;
    const std::map<std::string, std::size_t> orders{{"532", 60},  {"432", 24},  {"332", 12}, {"*532", 120},
                                                    {"*432", 48}, {"*332", 24}, {"3*2", 24}};
    for (const auto& [group, order] : orders) all.push_back({{.group = group}, order});
    for (const int n : {2, 3, 4, 5, 9, 16}) {
        all.push_back({{.group = "22n", .n = n}, 2U * static_cast<unsigned>(n)});
        all.push_back({{.group = "*22n", .n = n}, 4U * static_cast<unsigned>(n)});
        all.push_back({{.group = "2*n", .n = n}, 4U * static_cast<unsigned>(n)});
    }
    return all;
}

/// A corner anywhere or at a centre, and bent edges.
SphericalTileSettings bent_tile(SphericalTileSettings settings, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0, 1);
    const bool has_mirrors = settings.group.find('*') != std::string::npos;
    const unsigned center = seed % 4;
    for (unsigned i = 0; i < 3; ++i) settings.corner[i] = center < 3 ? i == center : 0.4 + part(random);
    const double bend = 0.12 * (settings.group.find('n') == std::string::npos ? 1 : std::min(1.0, 3.0 / settings.n));
    const std::size_t curves = !has_mirrors ? 3 : settings.group[0] == '*' ? 0 : 1;
    for (unsigned i = 0; i < curves; ++i)
        settings.curves.push_back(!has_mirrors && i == center ? PlaneCurve{}
                                                              : PlaneCurve{{0, 0},
                                                                           {0.3, bend * (part(random) - 0.5)},
                                                                           {0.5, bend * (part(random) - 0.5)},
                                                                           {0.7, bend * (part(random) - 0.5)},
                                                                           {1, 0}});
    return settings;
}

/// The solid angle of a polygon by signed triangles with a corner in common, but for multiples of 4 pi: van Oosterom
/// and Strackee, 1983.
double solid_angle(const SphericalPolygon& p)
{
    const UnitVector apex = unit({0.31, -0.64, 0.52}); // opposite no corner
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const UnitVector &a = p[i], &b = p[(i + 1) % p.size()];
        sum += 2 * std::atan2(dot(apex, cross(a, b)), 1 + dot(apex, a) + dot(a, b) + dot(b, apex));
    }
    const double whole = 4 * std::numbers::pi;
    return sum - whole * std::floor(sum / whole);
}

/// The number of times that a polygon goes around a place, less that around the opposite place.
double turns_around(const SphericalPolygon& polygon, const UnitVector& place)
{
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const UnitVector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        sum += std::atan2(dot(place, cross(p, q)), dot(p, q) - dot(p, place) * dot(q, place));
    }
    return sum / (2 * std::numbers::pi);
}

std::vector<UnitVector> side_of_tile(const SphericalTile& tile, std::uint32_t element, std::size_t side)
{
    std::vector<UnitVector> places;
    const std::size_t begin = tile.corners()[side],
                      end = side + 1 < tile.corners().size() ? tile.corners()[side + 1] : tile.outline().size();
    for (std::size_t i = begin; i <= end; ++i)
        places.push_back(moved(tile.group().isometry(element), tile.outline()[i % tile.outline().size()]));
    return places;
}

TEST(SphericalTile, GroupsHaveTheirOrdersAndAreGroups)
{
    for (const auto& [settings, order] : sphere_groups()) {
        const SphericalTile tile(settings);
        const SphericalGroup& group = tile.group();
        ASSERT_EQ(group.size(), order) << settings.group << settings.n;
        for (std::uint32_t i = 0; i < order; ++i) {
            std::set<std::uint32_t> row;
            for (std::uint32_t k = 0; k < order; ++k) {
                row.insert(group.product(i, k));
                const std::uint32_t m = (7 * i + 3 * k) % static_cast<std::uint32_t>(order);
                ASSERT_EQ(group.product(group.product(i, k), m), group.product(i, group.product(k, m)));
            }
            ASSERT_EQ(row.size(), order);
            EXPECT_EQ(group.product(i, group.inverse(i)), 0U);
        }
    }
}

/// Areas are those of Girard: 4 pi over the order; corners are the orbits of the corner and of the centres, and on
/// mirrors those of the corners of mirrors.
TEST(SphericalTile, FillTheSphereOnce)
{
    for (const auto& [plain, order] : sphere_groups())
        for (unsigned seed = 0; seed < 24; ++seed) {
            const SphericalTileSettings settings = bent_tile(plain, seed);
            const SphericalTile tile(settings);
            const double whole = 4 * std::numbers::pi;
            EXPECT_NEAR(area_of(tile.outline()), whole / static_cast<double>(order), 1e-12);
            EXPECT_NEAR(solid_angle(tile.outline()), whole / static_cast<double>(order), 1e-12);
            const auto [corners, edges, tiles] = tile.counts();
            EXPECT_EQ(tiles, order);
            EXPECT_EQ(corners + tiles, edges + 2) << settings.group << settings.n << ", " << seed;
            EXPECT_EQ(2 * edges, tiles * tile.sides().size());
            const bool is_rotated = settings.group.find('*') == std::string::npos;
            EXPECT_EQ(tile.sides().size(), !is_rotated ? (settings.group[0] == '*' ? 3U : 4U) : seed % 4 < 3 ? 4U : 6U);
            for (std::uint32_t element = 0; element < order; ++element)
                for (std::size_t i = 0; i < tile.sides().size(); ++i) {
                    const SphericalSide& side = tile.sides()[i];
                    const std::uint32_t beyond = tile.group().product(element, side.neighbour);
                    EXPECT_EQ(tile.group().product(beyond, tile.sides()[side.partner].neighbour), element);
                    const auto own = side_of_tile(tile, element, i);
                    auto other = side_of_tile(tile, beyond, side.partner);
                    if (!side.is_mirror) std::ranges::reverse(other);
                    ASSERT_EQ(own.size(), other.size());
                    for (std::size_t k = 0; k < own.size(); ++k)
                        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(own[k][c], other[k][c], 1e-12);
                }
        }
}

/// The tile, divided by the first of some paths that its shape allows.
SphericalTile split_tile_of(SphericalTileSettings settings)
{
    for (const TileSplit& split : {TileSplit{1, 3, {}}, {0, 2, {}}, {0, 1, {{0, 0}, {0.5, 0.15}, {1, 0}}}}) {
        settings.split = split;
        if (refusal_of([&] { SphericalTile{settings}; }) == "accepted") break;
    }
    return SphericalTile(settings);
}

TEST(SphericalTile, EachPlaceIsInOneTile)
{
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (const auto& [plain, order] : sphere_groups())
        for (unsigned seed = 0; seed < 4; ++seed) {
            const SphericalTile tile = split_tile_of(bent_tile(plain, seed));
            ASSERT_EQ(tile.parts().size(), 2U);
            const SphericalTiling tiling(tile);
            for (int number = 0; number < 60; ++number) {
                const UnitVector place = unit({normal(random), normal(random), normal(random)});
                const SphericalTiling::Found found = tiling.at(place);
                std::size_t tiles = 0;
                for (std::uint32_t i = 0; i < order; ++i) {
                    const UnitVector back = moved(tile.group().isometry(tile.group().inverse(i)), place);
                    std::array<bool, 2> is_in{};
                    for (std::size_t part = 0; part < 2; ++part)
                        is_in[part] = turns_around(tile.parts()[part], back) > 0.5;
                    EXPECT_EQ(is_in[0] || is_in[1], turns_around(tile.outline(), back) > 0.5);
                    tiles += is_in[0] + is_in[1];
                    if (!is_in[0] && !is_in[1]) continue;
                    EXPECT_EQ(found.element, i);
                    EXPECT_EQ(found.part, is_in[0] ? 0U : 1U);
                }
                EXPECT_EQ(tiles, 1U) << plain.group << plain.n;
            }
        }
}

/// All subgroups that three elements generate are compared; tiles of neighbours have to differ.
TEST(SphericalTile, ColoringsArePerfectAndHaveTheFewestColors)
{
    for (const auto& [plain, order] : sphere_groups())
        for (unsigned seed = 0; seed < 4; ++seed) {
            const SphericalTile tile(bent_tile(plain, seed));
            const SphericalGroup& group = tile.group();
            const std::vector<std::uint32_t> colors = tile.coloring();
            const std::uint32_t count = *std::ranges::max_element(colors) + 1;
            for (std::uint32_t i = 0; i < order; ++i) {
                std::map<std::uint32_t, std::uint32_t> becomes;
                for (std::uint32_t k = 0; k < order; ++k) {
                    const std::uint32_t color = colors[group.product(i, k)];
                    EXPECT_EQ(becomes.emplace(colors[k], color).first->second, color);
                }
                EXPECT_EQ(becomes.size(), count);
                for (const SphericalSide& side : tile.sides())
                    EXPECT_NE(colors[i], colors[group.product(i, side.neighbour)]);
            }
            if (order > 24) continue;
            std::size_t largest = 0;
            for (std::uint32_t i = 0; i < order * order * order; ++i) {
                const auto size = static_cast<std::uint32_t>(order);
                const std::vector<bool> subgroup = group.generated({i % size, i / size % size, i / size / size});
                const auto has = [&](const SphericalSide& s) { return bool{subgroup[s.neighbour]}; };
                if (std::ranges::none_of(tile.sides(), has))
                    largest =
                        std::max<std::size_t>(largest, static_cast<std::size_t>(std::ranges::count(subgroup, true)));
            }
            EXPECT_EQ(count, order / largest) << plain.group << plain.n;
        }
    // The five tetrahedra in a dodecahedron; with mirrors, rotations and reflections.
    EXPECT_EQ(std::ranges::max(SphericalTile({.group = "532"}).coloring()), 4U);
    EXPECT_EQ(std::ranges::max(SphericalTile({.group = "*532"}).coloring()), 1U);
}

TEST(SphericalTile, PathsDivideIt)
{
    // Around a centre of 3*2 tiles alternate, and their mirrors are those of the tiling: angels and devils.
    SphericalTileSettings settings{.group = "3*2"};
    settings.split = TileSplit{0, 2, {{0, 0}, {0.4, 0.05}, {0.7, -0.1}, {1, 0}}};
    const SphericalTile tile(settings);
    EXPECT_EQ(tile.alike(), 0U);
    EXPECT_NEAR(area_of(tile.parts()[0]) + area_of(tile.parts()[1]), area_of(tile.outline()), 1e-12);
    settings.split = TileSplit{1, 3, {}};
    EXPECT_THAT(message_of([&] { SphericalTile{settings}; }), HasSubstr("meets its outline")); // along the mirror
    settings.split = TileSplit{0, 1, {{0, 0}, {0.5, 0.2}, {1, 0}}};
    EXPECT_EQ(SphericalTile(settings).alike(), 0U);
    settings.split->path[1] = {0.5, -0.2};
    EXPECT_THAT(message_of([&] { SphericalTile{settings}; }), HasSubstr("meets its outline"));
    for (const std::size_t to : {0U, 4U}) {
        settings.split = TileSplit{0, to, {}};
        EXPECT_THAT(message_of([&] { SphericalTile{settings}; }), HasSubstr("two different corners of the 4, 0 to 3"));
    }
    // Between the poles, a tile of 22n with its corner there is a lune.
    for (const PlaneCurve& path : {PlaneCurve{}, {{0, 0}, {0.5, 0.1}, {1, 0}}})
        EXPECT_THAT(message_of([&] {
                        SphericalTile{{.group = "22n", .corner = {0, 0, 1}, .split = TileSplit{0, 2, path}}};
                    }),
                    HasSubstr("corners 0 and 2 lie opposite each other: no arc joins them"));
    // A path from a centre of order 5 to that of order 2 leaves two sides of one corner each side.
    EXPECT_EQ(SphericalTile({.split = TileSplit{1, 3, {}}}).alike(), 2U);
}

TEST(SphericalTile, RefusesWhatIsNone)
{
    const auto refused = [](const SphericalTileSettings& s) { return message_of([&] { SphericalTile{s}; }); };
    EXPECT_THAT(refused({.curves = {{{0, 0}, {0.5, 2}, {1, 0}}}}), HasSubstr("edges of the tile meet"));
    EXPECT_THAT(refused({.curves = {{{0, 0}, {0.6, 0}, {0.3, 0}, {1, 0}}}}), HasSubstr("edges of the tile meet"));
    EXPECT_THAT(refused({.curves = {{{0, 0}, {1, 0}, {1, 0}}}}), HasSubstr("edges of the tile meet"));
    EXPECT_THAT(refused({.corner = {0, 0, 0}}), HasSubstr("weight above 0"));
    EXPECT_THAT(refused({.corner = {0, 1, 0}, .curves = {{}, {{0, 0}, {0.5, 0.1}, {1, 0}}}}),
                HasSubstr("curve 1 must be []: the corner is the centre of order 3"));
    EXPECT_THAT(refused({.curves = {{}, {}, {}, {}}}), HasSubstr("tiles of 532 have at most three curves"));
    EXPECT_THAT(refused({.group = "*332", .curves = {{}}}), HasSubstr("tiles of *332 have no curves"));
    EXPECT_THAT(refused({.group = "3*2", .curves = {{}, {}}}), HasSubstr("tiles of 3*2 have at most one curve"));
}

/// On the equator, coordinates beside an arc are longitude and latitude.
TEST(SphericalTile, PlacesBesideArcsAreLongitudesAndLatitudes)
{
    for (const double length : {0.3, 1.5, 3.0})
        for (const double x : {-0.4, 0.0, 0.6, 1.0})
            for (const double y : {-0.2, 0.0, 0.3}) {
                const UnitVector place = place_beside({1, 0, 0}, {std::cos(length), std::sin(length), 0}, {x, y});
                EXPECT_NEAR(std::atan2(place[1], place[0]), x * length, 1e-14);
                EXPECT_NEAR(std::asin(place[2]), y * length, 1e-14);
            }
}

}
}
