// The regions of tiles as polygons and polyhedra: their corners, and that they are what positions are decided
// by.
#include "tiles/poisson/region_shapes.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace poissonlab {
namespace {

constexpr std::int32_t width = 4800;

double dot(const ShapeVector& a, const ShapeVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ShapeVector cross(const ShapeVector& a, const ShapeVector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The corners of a shape, each once, in tenths of the radius.
std::set<std::array<long, 3>> corners_of(const RegionShape& shape)
{
    std::set<std::array<long, 3>> corners;
    for (const ShapeFace& face : shape.faces)
        for (const ShapeVector& corner : face.corners) {
            std::array<long, 3> tenths{};
            for (std::size_t k = 0; k < 3; ++k) tenths[k] = std::lround(corner[k] / width * 10);
            corners.insert(tenths);
        }
    return corners;
}

/// The volume of a shape, in tiles, or the area of a polygon, as a sum over triangles.
double volume_of(const RegionShape& shape)
{
    const bool is_polygon = shape.faces.size() == 1;
    double sum = 0;
    for (const ShapeFace& face : shape.faces)
        for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
            const ShapeVector &a = face.corners[0], &b = face.corners[i], &c = face.corners[i + 1];
            sum += is_polygon ? cross(a, b)[2] + cross(b, c)[2] + cross(c, a)[2] : dot(a, cross(b, c)) / 3;
        }
    return sum / 2 / std::pow(tile_units, is_polygon ? 2 : 3);
}

TEST(RegionShapes, CornerTilesAreGreatRhombicuboctahedra)
{
    const RegionShape shape = region_shape(modified_regions(3, width), 0, {0, 0, 0});
    EXPECT_EQ(shape.faces.size(), 26u) << "12 squares, 8 hexagons, 6 octagons";
    std::set<std::array<long, 3>> expected;
    std::array<double, 3> lengths{1, 1 + std::sqrt(2), 1 + 2 * std::sqrt(2)};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            std::array<long, 3> corner{};
            for (std::size_t k = 0; k < 3; ++k) corner[k] = std::lround((signs >> k & 1 ? -10 : 10) * lengths[k]);
            expected.insert(corner);
        }
    } while (std::ranges::next_permutation(lengths).found);
    EXPECT_EQ(expected.size(), 48u);
    EXPECT_EQ(corners_of(shape), expected);
}

TEST(RegionShapes, EdgesAndFacesAreOctagonal)
{
    const TileRegions regions = modified_regions(3, width);
    for (std::uint8_t axes = 1; axes < all_axes(3); ++axes) {
        const RegionShape shape = region_shape(regions, axes, {1, -2, 3});
        EXPECT_EQ(shape.faces.size(), 10u);
        EXPECT_EQ(std::ranges::count_if(shape.faces, [](const ShapeFace& f) { return f.corners.size() == 8; }), 2);
    }
    EXPECT_EQ(region_shape(modified_regions(2, width), 0, {}).faces.at(0).corners.size(), 8u);
    EXPECT_EQ(region_shape(modified_regions(2, width), 1, {}).faces.at(0).corners.size(), 4u);
    EXPECT_EQ(region_shape(modified_regions(2, width), 3, {}).faces.at(0).corners.size(), 8u);
}

TEST(RegionShapes, HaveTheVolumesOfTheRegions)
{
    for (const int dimension : {2, 3}) {
        const TileRegions regions = modified_regions(dimension, width);
        for (std::uint8_t axes = 0; axes <= all_axes(dimension); ++axes)
            EXPECT_NEAR(volume_of(region_shape(regions, axes, {0, 1, 0})), regions.volume(axes), 2e-5)
                << dimension << "D, axes " << int{axes};
    }
}

TEST(RegionShapes, OfATileFillIt)
{
    for (const int dimension : {2, 3})
        for (const bool modified : {false, true}) {
            const TileRegions regions =
                modified ? modified_regions(dimension, width) : unmodified_regions(dimension, width);
            double sum = 0;
            for (std::uint8_t axes = 0; axes <= all_axes(dimension); ++axes)
                for (std::int32_t upper = 0; upper <= all_axes(dimension); ++upper) {
                    if ((upper & axes) != 0) continue;
                    const RegionShape whole = region_shape(regions, axes, {upper & 1, upper >> 1 & 1, upper >> 2 & 1});
                    const double side = tile_units;
                    sum += volume_of(clipped_to_box(whole, dimension, {0, 0, 0}, {side, side, side}));
                }
            EXPECT_NEAR(sum, 1, 1e-9) << dimension << "D, modified " << modified;
        }
}

TEST(RegionShapes, FacesLookOutwards)
{
    const RegionShape shape = region_shape(modified_regions(3, width), 7, {0, 0, 0});
    const ShapeVector middle{tile_units / 2.0, tile_units / 2.0, tile_units / 2.0};
    for (const ShapeFace& face : shape.faces) {
        ShapeVector out{};
        for (std::size_t k = 0; k < 3; ++k) out[k] = face.corners[0][k] - middle[k];
        EXPECT_GT(dot(face.normal, out), 0);
        ShapeVector first{}, second{};
        for (std::size_t k = 0; k < 3; ++k) {
            first[k] = face.corners[1][k] - face.corners[0][k];
            second[k] = face.corners[2][k] - face.corners[1][k];
        }
        EXPECT_GT(dot(cross(first, second), face.normal), 0) << "counterclockwise";
    }
}

TEST(RegionShapes, ClippingCanLeaveNothing)
{
    const RegionShape box = box_shape(3, {0, 0, 0}, {1, 1, 1});
    EXPECT_TRUE(clipped(box, {{1, 0, 0}, -1}).faces.empty());
    EXPECT_TRUE(clipped(box, {{1, 0, 0}, 0}).faces.empty()) << "a face has no volume";
    EXPECT_EQ(clipped(box, {{1, 0, 0}, 1}).faces.size(), 6u);
    EXPECT_EQ(clipped(box, {{1, 1, 1}, 2.5}).faces.size(), 7u);
}

}
}
