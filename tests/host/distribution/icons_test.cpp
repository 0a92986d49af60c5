// Icons of fields that are known; disks that do not meet, in integers.
#include "host/distribution/icons.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/raw_png.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

IconSettings rotation()
{
    IconSettings settings;
    settings.u = "-y";
    settings.v = "x";
    return settings;
}

SquarePoints jittered(std::uint32_t side)
{
    SquarePoints points;
    std::uint32_t bits = 12345;
    const std::uint32_t cell = 0xffffffff / side;
    for (std::uint32_t i = 0; i < side * side; ++i)
        for (const std::uint32_t place : {i % side, i / side}) {
            bits = bits * 1664525 + 1013904223;
            points.push_back(place * cell + cell / 4 + bits % (cell / 2));
        }
    return points;
}

std::int64_t squared_size(const IconPoint& p) { return p[0] * p[0] + p[1] * p[1]; }

TEST(Icons, StayInDisksThatDoNotMeet)
{
    const Icons icons = icons_at(jittered(20), read_field(rotation()), false);
    ASSERT_EQ(icons.icons.size(), 400);
    std::int64_t least = std::int64_t{1} << 62;
    for (std::size_t i = 0; i < icons.icons.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const auto &a = icons.icons[i].place, &b = icons.icons[k].place;
            least = std::min(least, squared_size({a[0] - b[0], a[1] - b[1]}));
        }
        for (const auto& ends : icons.icons[i].strokes)
            for (const IconPoint& end : ends) {
                // An end with its round cap: |end| + width / 2 <= radius.
                const std::int64_t room = icons.radius - (icons.width + 1) / 2;
                EXPECT_LE(squared_size(end), room * room) << i;
            }
    }
    EXPECT_LE(4 * icons.radius * icons.radius, least);
    EXPECT_GT(4 * (icons.radius + 1) * (icons.radius + 1), least);
    EXPECT_GT(icons.radius, icon_units / 100);
}

/// The field turns about the middle of the square: strokes lie across the direction to it, and those at its border are
/// the longest.
TEST(Icons, ShowARotationByTangents)
{
    const Icons icons = icons_at(jittered(12), read_field(rotation()), false);
    double longest = 0;
    for (const Icon& icon : icons.icons) {
        const double x = static_cast<double>(icon.place[0]) - icon_units / 2.0;
        const double y = static_cast<double>(icon.place[1]) - icon_units / 2.0;
        if (icon.strokes.empty()) continue;
        const auto& [tail, tip] = icon.strokes.front();
        const double dx = static_cast<double>(tip[0] - tail[0]), dy = static_cast<double>(tip[1] - tail[1]);
        const double size = std::hypot(dx, dy), away = std::hypot(x, y);
        // A vector is that of a pixel's middle, at most 0.71 of 1/1,024 from the place.
        EXPECT_NEAR((dx * x + dy * y) / (size * away), 0, 1.5 * icon_units / 1024 / away);
        EXPECT_GT(dy * x - dx * y, 0);
        longest = std::max(longest, size);
    }
    EXPECT_NEAR(longest, 2.0 * static_cast<double>(icons.radius - icons.width / 2 - 2), 4);
}

TEST(Icons, AreDotsAndHolesWhereThereIsNoVector)
{
    IconSettings settings;
    settings.u = "x < -0.5 ? sqrt(-1) : (x < 0 ? 0 : 1)";
    settings.v = "0";
    const Icons icons = icons_at(jittered(8), read_field(settings), true);
    EXPECT_EQ(icons.holes, 16);
    ASSERT_EQ(icons.icons.size(), 48);
    for (const Icon& icon : icons.icons)
        EXPECT_EQ(icon.strokes.empty(), icon.place[0] < icon_units / 2) << icon.place[0];
    const MarkPicture picture = icon_picture(icons, read_field(settings));
    EXPECT_EQ(picture.groups[0].strokes.size(), 3 * 32);
    EXPECT_EQ(picture.groups[1].disks.size(), 16);
    EXPECT_EQ(icons_csv(icons).substr(0, 8), "x,y,u,v\n");
}

/// Transparent pixels on the left; alpha is no second component.
TEST(Icons, AreHolesWhereAPictureIsTransparent)
{
    const TemporaryFolder folder;
    IconSettings settings;
    settings.field = folder.path() / "field.png";
    test::write_raw_png(settings.field, {2, 1, 4, 8, {255, 0, 0, 0, 255, 0, 0, 255}});
    const VectorField field = read_field(settings);
    EXPECT_TRUE(std::isnan(field.u.values[0]));
    EXPECT_EQ(field.u.values[1], 1);
    EXPECT_EQ(icons_at(jittered(8), field, true).holes, 32);
    test::write_raw_png(settings.field, {1, 1, 2, 8, {255, 255}});
    EXPECT_THAT(message_of([&] { read_field(settings); }),
                testing::HasSubstr("field.png: has one channel beside alpha; a field needs two"));
}

TEST(Icons, FindTheNearestPairAsAllPairsDo)
{
    EXPECT_EQ(least_squared_distance({{0, 0}}), 0);
    EXPECT_EQ(least_squared_distance({{5, 5}, {1, 2}, {100, 7}, {1, -2}}), 16);
    EXPECT_EQ(least_squared_distance({{5, 5}, {5, 5}}), 0);
}

TEST(Icons, AreRefusedForFieldsWithoutVectors)
{
    IconSettings settings;
    settings.u = settings.v = "0";
    EXPECT_THAT(message_of([&] { read_field(settings); }), testing::HasSubstr("the field has no vectors"));
    settings.u = "1/0";
    EXPECT_THAT(message_of([&] { read_field(settings); }), testing::HasSubstr("is (inf, 0): must be numbers up to"));
    settings.u = "-1e200"; // whose square is no number
    EXPECT_THAT(message_of([&] { read_field(settings); }),
                testing::HasSubstr("is (-1e+200, 0): must be numbers up to"));
}

}
}
