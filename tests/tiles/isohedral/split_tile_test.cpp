// Tiles that a path divides: their parts fill the plane, and they meet as the split says.
#include "tiles/isohedral/split_tile.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// Places of a window are classified by brute force: the parts of all tiles around cover each place once, and two
/// places on both sides of an edge lie in different parts if and only if the tiling is a Heaven and Hell pattern there.
TEST(SplitTiles, MeetAsTheySay)
{
    const auto is_inside = [](const std::vector<PlanePoint>& outline, const PlanePoint& at) {
        bool inside = false;
        for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
            if ((outline[i][1] > at[1]) != (outline[j][1] > at[1]) &&
                at[0] < outline[i][0] +
                            (outline[j][0] - outline[i][0]) * (at[1] - outline[i][1]) / (outline[j][1] - outline[i][1]))
                inside = !inside;
        return inside;
    };
    int patterns = 0;
    for (const IsohedralType& type : isohedral_types()) {
        const IsohedralTile tile(type, {});
        const std::size_t n = tile.corners().size();
        for (std::size_t from = 0; from < n; ++from)
            for (std::size_t to = from + 1; to < n; ++to) {
                if (to == from + 1 || (from == 0 && to + 1 == n)) { // a straight path along an edge
                    EXPECT_THAT(message_of([&] { split_tile(tile, {from, to, {}}); }), HasSubstr("meets its outline"));
                    continue;
                }
                const SplitTile split = split_tile(tile, {from, to, {}});
                EXPECT_NEAR(area_of(split.parts[0]) + area_of(split.parts[1]), area_of(tile.outline()), 1e-12);
                const auto parts_at = [&](const PlanePoint& at) {
                    std::vector<std::size_t> found;
                    for (const TilePlace& place :
                         tile.tiles_near({at[0] - 1e-6, at[1] - 1e-6}, {at[0] + 1e-6, at[1] + 1e-6}))
                        for (std::size_t part = 0; part < 2; ++part) {
                            std::vector<PlanePoint> outline;
                            for (const PlanePoint& p : split.parts[part]) outline.push_back(tile.motion(place)(p));
                            if (is_inside(outline, at)) found.push_back(part);
                        }
                    return found;
                };
                std::size_t alike = 0;
                for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect)
                    for (std::size_t edge = 0; edge < n; ++edge) {
                        const PlaneMotion motion = tile.motion({aspect, 0, 0});
                        const PlanePoint a = motion(tile.corners()[edge]), b = motion(tile.corners()[(edge + 1) % n]);
                        std::array<std::vector<std::size_t>, 2> sides;
                        for (const std::size_t side : {0, 1}) {
                            const double away = side == 0 ? 1e-3 : -1e-3, t = 0.43;
                            sides[side] = parts_at({a[0] + t * (b[0] - a[0]) - away * (b[1] - a[1]),
                                                    a[1] + t * (b[1] - a[1]) + away * (b[0] - a[0])});
                            ASSERT_EQ(sides[side].size(), 1) << type.number;
                        }
                        alike += sides[0] == sides[1];
                    }
                EXPECT_EQ(split.alike, alike) << type.number << " " << from << " " << to;
                patterns += alike == 0;
            }
    }
    EXPECT_GT(patterns, 0);
}

TEST(SplitTiles, NeedAPathInside)
{
    const IsohedralTile square(isohedral_types()[40], {}); // IH41, translations alone
    EXPECT_THAT(message_of([&] {
                    split_tile(square, {0, 0, {}});
                }),
                HasSubstr("two different corners of the 4, 0 to 3"));
    EXPECT_THAT(message_of([&] { split_tile(square, {0, 4, {}}); }), HasSubstr("two different corners"));
    EXPECT_THAT(message_of([&] { split_tile(square, {0, 2, {{0, 0}, {0.5, 2}, {1, 0}}}); }), HasSubstr("meets"));
    EXPECT_EQ(split_tile(square, {2, 0, {{0, 0}, {0.3, 0.2}, {0.7, -0.2}, {1, 0}}}).alike, 0);
}

}
}
