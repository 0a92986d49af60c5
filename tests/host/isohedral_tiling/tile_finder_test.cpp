// Which tile a place is in: the kernel against its twin, and the twin against outlines in the plane.
#include "host/isohedral_tiling/tile_finder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

/// Random places, and places on the grid of the translations, where corners and edges are.
std::vector<LatticePoint> tried_points(std::size_t count)
{
    std::mt19937_64 random(11);
    std::vector<LatticePoint> points;
    for (std::size_t i = 0; i < count; ++i) {
        const auto number = [&] {
            return static_cast<std::int64_t>(random() % (8ull << lattice_bits)) - (4ll << lattice_bits);
        };
        points.push_back({number(), number()});
    }
    for (std::int64_t x = -12; x <= 12; ++x)
        for (std::int64_t y = -12; y <= 12; ++y) points.push_back({(x << lattice_bits) / 6, (y << lattice_bits) / 6});
    return points;
}

class TileFinderCases : public testing::TestWithParam<int>
{
};

TEST_P(TileFinderCases, FindsTheTilesOfItsTwin)
{
    const IsohedralType& type = isohedral_types()[static_cast<std::size_t>(GetParam() - 1)];
    const TileLookup lookup(random_tile(type, 2, 0.3, 0.12));
    const auto points = tried_points(GetParam() == 28 ? 20'000 : 200);
    for (const std::size_t group : {1, 64})
        EXPECT_EQ(TileFinder(Device::open(), lookup, group).find(points), reference::find_tiles(lookup, points));
}

INSTANTIATE_TEST_SUITE_P(Small, TileFinderCases, testing::Values(16, 77));
INSTANTIATE_TEST_SUITE_P(Large, TileFinderCases, testing::Values(1, 28, 43));

/// True if a point of the plane is inside of a tile, with the distance to its outline.
struct InsideTest
{
    bool is_inside = false;
    double distance = 1e300;
};

InsideTest inside_test(const IsohedralTile& tile, const PlaneMotion& motion, const PlanePoint& p)
{
    InsideTest test;
    const auto& outline = tile.outline();
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const PlanePoint a = motion(outline[i]), b = motion(outline[(i + 1) % outline.size()]);
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]))
            test.is_inside = !test.is_inside;
        const double dx = b[0] - a[0], dy = b[1] - a[1];
        const double along = std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        test.distance = std::min(test.distance, std::hypot(a[0] + along * dx - p[0], a[1] + along * dy - p[1]));
    }
    return test;
}

TEST(TileLookup, PlacesAreInTheTilesThatAreFound)
{
    std::mt19937_64 random(3);
    for (const IsohedralType& type : isohedral_types()) {
        const IsohedralTile tile = random_tile(type, 7, 0.3, 0.12);
        const TileLookup lookup(tile);
        for (int i = 0; i < 60; ++i) {
            const auto number = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53) * 20 - 10; };
            const PlanePoint p{number(), number()};
            const FoundTile found = reference::find_tiles(lookup, std::vector{lookup.lattice_point(p)})[0];
            const PlaneMotion motion = tile.motion(found.place);
            const InsideTest test = inside_test(tile, motion, p);
            // Outlines and places are rounded to 2^-26 of the translations, of which some are some 10 long.
            EXPECT_TRUE(test.is_inside || test.distance < 1e-6) << "IH" << type.number;
            const PlanePoint offset = lookup.offset_of(found);
            EXPECT_NEAR(motion.x + offset[0], p[0], 1e-6);
            EXPECT_NEAR(motion.y + offset[1], p[1], 1e-6);
        }
    }
}

TEST(TileLookup, EveryPlaceIsInExactlyOneTile)
{
    // Without the first candidate that has a place no other one has it, also on edges and at corners.
    for (const IsohedralType& type : isohedral_types()) {
        TileLookup lookup(random_tile(type, 9, 0.3, 0.12));
        std::vector<LatticePoint> points = tried_points(20);
        for (const auto& corner : lookup.corners) points.push_back({corner[0], corner[1]});
        for (const LatticePoint& point : points) {
            TileLookup others = lookup;
            const FoundTile found = reference::find_tiles(lookup, std::vector{point})[0];
            const TilePlace own{found.place.aspect,
                                found.place.column - static_cast<std::int32_t>(point[0] >> lattice_bits),
                                found.place.row - static_cast<std::int32_t>(point[1] >> lattice_bits)};
            std::erase_if(others.candidates, [&](const LookupCandidate& c) { return c.place == own; });
            EXPECT_THROW(reference::find_tiles(others, std::vector{point}), std::logic_error) << "IH" << type.number;
        }
    }
}

TEST(TileFinderMemory, IsForetold)
{
    const TileLookup lookup(random_tile(isohedral_types()[27], 2, 0.3, 0.12));
    const auto points = tried_points(5000);
    Device device = Device::open();
    const std::uint64_t before = device.memory().total;
    device.watch_memory();
    TileFinder finder(device, lookup);
    finder.find(points);
    const DeviceMemory taken{device.peak_memory().largest, device.peak_memory().total - before};
    const DeviceMemory foretold = finder.memory(points.size());
    EXPECT_GE(foretold.total, taken.total);
    EXPECT_GE(foretold.largest, taken.largest);
    EXPECT_LE(static_cast<double>(foretold.total), 1.3 * static_cast<double>(taken.total));
}

}
}
