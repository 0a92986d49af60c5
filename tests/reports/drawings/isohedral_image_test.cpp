// Pictures of isohedral tilings: the windows of the gallery are full.
#include "reports/drawings/tilings/isohedral_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

double polygon_area(const Polygon& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const DrawingPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return std::abs(twice) / 2;
}

/// A gallery of one panel, with a random tile.
Drawing gallery_of(const IsohedralType& type)
{
    const IsohedralTile tile = random_tile(type, 1, drawn_deformation, drawn_amplitude);
    return draw_isohedral_gallery({{"one", tile, proper_coloring(tile)}}, 1);
}

TEST(IsohedralGallery, FillsItsWindowsOnce)
{
    for (const IsohedralType& type : isohedral_types()) {
        const Drawing drawing = gallery_of(type);
        // The frame is the last polygon; within it lie the tiles, cut where they reach beyond, each place in one.
        std::vector<Polygon> filled;
        Polygon frame;
        for (const Shape& shape : drawing.shapes)
            if (const auto* polygon = std::get_if<Polygon>(&shape.form))
                (shape.fill.empty() ? frame = *polygon : filled.emplace_back(*polygon));
        const auto [low, high] = std::ranges::minmax(frame);
        double area = 0;
        for (const Polygon& polygon : filled) {
            area += polygon_area(polygon);
            for (const DrawingPoint& p : polygon)
                for (const std::size_t axis : {0, 1}) {
                    EXPECT_GE(p[axis], low[axis]) << type.number;
                    EXPECT_LE(p[axis], high[axis]) << type.number;
                }
        }
        EXPECT_NEAR(area / polygon_area(frame), 1, 1e-9) << "IH" << type.number;
        EXPECT_GT(filled.size(), 20U) << "a window of 5 x 5 tiles";
    }
}

}
}
