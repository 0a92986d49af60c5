// The proof against what tilings really hold: brute force over neighbourhoods, and CGAL on whole tilings.
#include "tiles/poisson/proof/tile_certificate.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/largest_empty_ball.hpp"
#include "tests/support/errors.hpp"
#include "tests/tiles/poisson/made_up_tile_sets.hpp"
#include "tests/tiles/poisson/made_up_tilings.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <bit>
#include <cmath>
#include <map>
#include <ostream>
#include <string>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Case
{
    const char* name;
    PoissonTileParameters parameters;
    int period; ///< of the tilings, a power of two
};

std::ostream& operator<<(std::ostream& stream, const Case& c) { return stream << c.name; }

/// Sets are made once for all tests.
const PoissonTileSet& set_of(const Case& c)
{
    static std::map<std::string, PoissonTileSet> sets;
    auto found = sets.find(c.name);
    if (found == sets.end()) found = sets.emplace(c.name, made_up(c.parameters)).first;
    return found->second;
}

class Certificate : public testing::TestWithParam<Case>
{
protected:
    const Case& c_ = GetParam();
    const PoissonTileSet& set_ = set_of(c_);
    const TileCertificate certificate_ = certify(set_);
};

/// The proven minimum distance, in tiles.
double proven_distance(const TileCertificate& certificate)
{
    return std::sqrt(static_cast<double>(certificate.squared_min_distance)) / tile_units;
}

TEST_P(Certificate, IsWhatWasAskedFor)
{
    EXPECT_GE(certificate_.squared_min_distance, asked_squared_distance(c_.parameters));
    EXPECT_EQ(certificate_.squared_min_distance,
              std::min(certificate_.squared_closure_distance, certificate_.squared_separation));
    EXPECT_GE(certificate_.relative_radius, c_.parameters.relative_radius);
    EXPECT_LT(certificate_.relative_radius,
              c_.parameters.relative_radius * 1.05); // these sets are dense enough
}

TEST_P(Certificate, HoldsForTilings)
{
    double smallest = 2;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const PointSet points = MadeUpTiling(c_.parameters, c_.period, seed).on_torus(set_);
        smallest = std::min(smallest, min_toroidal_distance(points) * c_.period);
    }
    EXPECT_GE(smallest, proven_distance(certificate_) * (1 - 1e-12));
}

TEST_P(Certificate, NoCircleOfATilingIsLarger)
{
    const PointSet points = MadeUpTiling(c_.parameters, c_.period, 1).on_torus(set_);
    const double largest = largest_empty_ball(points).radius * c_.period;
    EXPECT_LE(largest, certificate_.largest_empty_radius);
    EXPECT_GT(largest, certificate_.largest_empty_radius * 0.7);
    EXPECT_NEAR(certificate_.largest_empty_radius_in_min_distances * proven_distance(certificate_),
                certificate_.largest_empty_radius, 1e-12);
}

TEST_P(Certificate, CountsEveryPointOnce)
{
    double sum = 0;
    double covered = 0;
    const TileRegions regions = regions_of(c_.parameters);
    for (int i = 0; i <= c_.parameters.dimension; ++i) {
        const RegionCounts& counts = certificate_.regions[static_cast<std::size_t>(i)];
        EXPECT_LE(counts.min, counts.mean);
        EXPECT_LE(counts.mean, counts.max);
        sum += counts.mean;
        double volume = 0;
        for (unsigned axes = 0; axes < 1u << c_.parameters.dimension; ++axes)
            if (std::popcount(axes) == i) volume += regions.volume(static_cast<std::uint8_t>(axes));
        covered += counts.density * volume;
    }
    EXPECT_NEAR(sum, c_.parameters.points_per_tile, 1e-9);
    EXPECT_NEAR(covered, 1, 1e-9);
}

TEST_P(Certificate, IsTheSameForAnyNumberOfThreads)
{
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(certify(set_), certificate_);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Certificate,
                         testing::Values(Case{"Corner1", corner_parameters(1), 8},
                                         Case{"Corner2", corner_parameters(2), 32},
                                         Case{"Corner3", corner_parameters(3), 32},
                                         Case{"Edge1", edge_parameters(1), 8}, Case{"Edge2", edge_parameters(2), 32},
                                         Case{"Template", template_parameters(3), 32},
                                         Case{"Sphere2", sphere_parameters(2), 4}),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

/// The smallest distance among all points of a list.
std::uint64_t brute_force(const std::vector<TestPosition>& points)
{
    std::int64_t smallest = INT64_MAX;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) smallest = std::min(smallest, squared_distance(points[i], points[j]));
    return static_cast<std::uint64_t>(smallest);
}

void append_tile(const PoissonTileSet& set, std::uint32_t tile, const TestPosition& at, std::vector<TestPosition>& to)
{
    const auto coordinates = set.tile(tile);
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    for (std::size_t p = 0; p < coordinates.size(); p += dimension) {
        TestPosition position{};
        for (std::size_t k = 0; k < dimension; ++k) position[k] = coordinates[p + k] + at[k] * tile_units;
        to.push_back(position);
    }
}

/// The smallest distance in all 2 x 2 tiles of a corner set of two colours.
std::uint64_t smallest_in_corner_neighbourhoods(const PoissonTileSet& set)
{
    std::uint64_t smallest = UINT64_MAX;
    for (unsigned colors = 0; colors < 512; ++colors) {
        const auto color = [&](int x, int y) { return colors >> (3 * y + x) & 1; };
        std::vector<TestPosition> points;
        for (int y = 0; y < 2; ++y) {
            for (int x = 0; x < 2; ++x) {
                const unsigned tile =
                    color(x + 1, y + 1) << 3 | color(x + 1, y) << 2 | color(x, y) << 1 | color(x, y + 1);
                append_tile(set, tile, {x, y, 0}, points);
            }
        }
        smallest = std::min(smallest, brute_force(points));
    }
    return smallest;
}

void expect_sharp(const TileCertificate& certificate, std::uint64_t smallest)
{
    EXPECT_GE(smallest, certificate.squared_min_distance);
    EXPECT_LE(smallest, certificate.squared_closure_distance);
    if (certificate.squared_closure_distance <= certificate.squared_separation) {
        EXPECT_EQ(smallest, certificate.squared_min_distance);
    }
}

TEST(TileCertificate, IsTheSmallestDistanceInAllCornerNeighbourhoods)
{
    int sharp = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        const PoissonTileSet set = made_up(corner_parameters(2, 24), seed);
        const TileCertificate certificate = certify(set);
        expect_sharp(certificate, smallest_in_corner_neighbourhoods(set));
        sharp += certificate.squared_closure_distance <= certificate.squared_separation;
    }
    EXPECT_GT(sharp, 0);
}

TEST(TileCertificate, IsTheSmallestDistanceInAllTemplateNeighbourhoods)
{
    const PoissonTileSet set = made_up(template_parameters(3));
    std::uint64_t smallest = UINT64_MAX;
    for (unsigned choice = 0; choice < 81; ++choice) {
        std::vector<TestPosition> points;
        append_tile(set, choice % 3, {0, 0, 0}, points);
        append_tile(set, choice / 3 % 3, {1, 0, 0}, points);
        append_tile(set, choice / 9 % 3, {0, 1, 0}, points);
        append_tile(set, choice / 27, {1, 1, 0}, points);
        smallest = std::min(smallest, brute_force(points));
    }
    expect_sharp(certify(set), smallest);
}

TEST(TileCertificate, IsTheSmallestDistanceInAllPairsOfSphereTiles)
{
    // Tiles beside each other along x; every tile is one of a pair.
    const PoissonTileSet set = made_up(sphere_parameters(2));
    std::uint64_t smallest = UINT64_MAX;
    for (unsigned colors = 0; colors < 4096; ++colors) {
        const auto color = [&](unsigned x, unsigned y, unsigned z) { return colors >> (4 * x + 2 * y + z) & 1; };
        std::vector<TestPosition> points;
        for (unsigned x = 0; x < 2; ++x) {
            unsigned tile = 0;
            for (const unsigned z : {1u, 0u})
                tile = tile << 4 | color(x + 1, 1, z) << 3 | color(x + 1, 0, z) << 2 | color(x, 0, z) << 1 |
                       color(x, 1, z);
            append_tile(set, tile, {x, 0, 0}, points);
        }
        smallest = std::min(smallest, brute_force(points));
    }
    const TileCertificate certificate = certify(set);
    EXPECT_GE(smallest, certificate.squared_min_distance);
    EXPECT_LE(std::sqrt(static_cast<double>(smallest)),
              std::sqrt(static_cast<double>(certificate.squared_min_distance)) * 1.02);
}

TEST(TileCertificate, OfTheSameGridEverywhereIsThatOfTheTorus)
{
    for (const PoissonTileParameters& p : {corner_parameters(2, 64, 0.6), edge_parameters(1), template_parameters(4)}) {
        const PoissonTileSet set = same_grid_everywhere(p, 900);
        const TileCertificate certificate = certify(set);
        std::vector<TestPosition> points;
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 3; ++x) append_tile(set, 0, {x, y, 0}, points);
        const std::uint64_t smallest = brute_force(points);
        expect_sharp(certificate, smallest);
        EXPECT_EQ(certificate.squared_closure_distance, smallest);
        EXPECT_EQ(certificate.regions[2].min, certificate.regions[2].max);
    }
}

/// The index of a coordinate of a point of a tile in the region of a cell that extends along so many axes.
std::size_t point_in_region(const PoissonTileSet& set, std::uint32_t tile, int cell_dimension, std::size_t skip = 0)
{
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    const TileRegions regions = regions_of(set.parameters);
    const auto points = set.tile(tile);
    for (std::size_t i = 0; i < points.size(); i += dimension) {
        if (std::popcount(regions.cell_of(points.subspan(i, dimension)).axes) == cell_dimension && skip-- == 0)
            return tile * points.size() + i;
    }
    throw std::logic_error("no such point");
}

std::string refusal(const PoissonTileSet& set)
{
    return refusal_of([&] { certify(set); });
}

TEST(TileCertificate, RefusesTilesThatDoNotFitTogether)
{
    for (const PoissonTileParameters& p :
         {corner_parameters(2), edge_parameters(2), template_parameters(3), sphere_parameters(2)}) {
        const PoissonTileSet set = made_up(p);
        ASSERT_EQ(refusal(set), "accepted");
        for (int cell_dimension = 0; cell_dimension < p.dimension; ++cell_dimension) {
            const std::uint32_t tile = p.tiles - 1;
            PoissonTileSet moved = set;
            moved.points[point_in_region(set, tile, cell_dimension)] ^= 1;
            EXPECT_THAT(refusal(moved), StartsWith("tile "));
            EXPECT_THAT(refusal(moved), HasSubstr("differ from tile "));
        }
    }
}

TEST(TileCertificate, NamesTileAndCell)
{
    // Template tiles with no points but inside, and one with one in the middle of its upper edge.
    PoissonTileParameters p = template_parameters(3);
    p.points_per_tile = 4;
    p.relative_radius = 0.2;
    PoissonTileSet set{p, 0, {}};
    for (int tile = 0; tile < 3; ++tile)
        for (const int x : {20000, 20000, 40000, 20000, 20000, 40000, 40000, 40000})
            set.points.push_back(static_cast<std::uint16_t>(x));
    ASSERT_EQ(refusal(set), "accepted");
    PoissonTileSet moved = set;
    moved.points[2 * 8 + 5] = 65530;
    EXPECT_EQ(refusal(moved), "tile 2: points near its edge (x, 1), variant 0, differ from tile 0's: must be the same "
                              "in all tiles that have it");
    moved.points[2 * 8 + 4] = 3;
    EXPECT_THAT(refusal(moved), StartsWith("tile 2: points near its corner (0, 1), variant 0, differ from tile 0's"));
    moved = set;
    moved.points[8 + 6] = 20000;
    EXPECT_EQ(refusal(moved), "tile 1: two points at (20000, 40000): must differ");
    moved.points.pop_back();
    EXPECT_EQ(refusal(moved), "23 coordinates: must be 24");
}

TEST(TileCertificate, IsLoweredByPointsThatAreNear)
{
    for (const PoissonTileParameters& p : {corner_parameters(2), template_parameters(3), sphere_parameters(2)}) {
        PoissonTileSet set = made_up(p);
        const std::uint32_t tile = p.tiles / 2;
        const std::size_t a = point_in_region(set, tile, p.dimension);
        const std::size_t b = point_in_region(set, tile, p.dimension, 1);
        for (std::size_t k = 0; k < static_cast<std::size_t>(p.dimension); ++k) set.points[b + k] = set.points[a + k];
        set.points[b + 1] = static_cast<std::uint16_t>(set.points[b + 1] + (set.points[b + 1] < 32768 ? 7 : -7));
        EXPECT_EQ(certify(set).squared_min_distance, 49U);
        EXPECT_EQ(certify(set).squared_closure_distance, 49U);
    }
}

TEST(TileCertificate, SeparationIsThatOfPointsNearBorders)
{
    for (const PoissonTileParameters& p : {corner_parameters(2), template_parameters(3), sphere_parameters(2)}) {
        PoissonTileSet set = made_up(p);
        const auto width = static_cast<std::uint16_t>(regions_of(p).width);
        const std::size_t a = point_in_region(set, 0, p.dimension);
        const std::size_t b = point_in_region(set, p.tiles - 1, p.dimension);
        for (std::size_t k = 0; k < static_cast<std::size_t>(p.dimension); ++k) {
            set.points[a + k] = k == 0 ? width : 32768;
            set.points[b + k] = k == 0 ? static_cast<std::uint16_t>(65536 - width) : 32768;
        }
        EXPECT_EQ(certify(set).squared_separation, std::uint64_t{4} * width * width);
    }
}

}
}
