// The field of Gaussian blue noise where cells are listed: strips at several angles against closed forms, and sets that
// do not depend on which cells are listed, nor on the engine and its work-groups.
#include "host/sampling/regions/region_field.hpp"

#include "base/regions/region_text.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "tests/support/errors.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using std::numbers::pi;
using Place = std::array<double, 2>;

/// A strip from the origin on at an angle.
struct Strip
{
    double length, width, degrees;

    /// The place in the plane of one that is so far along the strip and across.
    Place placed(double along, double across) const
    {
        const double angle = degrees * pi / 180, c = std::cos(angle), s = std::sin(angle);
        return {along * c - across * s, along * s + across * c};
    }

    Place within(const Place& place) const
    {
        const double angle = degrees * pi / 180, c = std::cos(angle), s = std::sin(angle);
        return {place[0] * c + place[1] * s, place[1] * c - place[0] * s};
    }

    FixedRegion region() const
    {
        std::string corners;
        for (const auto& [x, y] :
             {placed(0, 0), placed(length, 0), placed(length, width), placed(0, width), placed(0, 0)})
            corners += fmt::format("{}{:.15g} {:.15g}", corners.empty() ? "" : ", ", x, y);
        return FixedRegion(read_region("POLYGON ((" + corners + "))", {.is_planar = true}));
    }
};

/// Returns the part of a Gaussian at a place that lies between 0 and `end`, and the slope of that part.
Place blurred_interval(double place, double end, double sigma)
{
    const auto below = [&](double x) { return 0.5 * std::erfc(-x / sigma / std::numbers::sqrt2); };
    const auto density = [&](double x) { return std::exp(-0.5 * x * x / (sigma * sigma)) / sigma / std::sqrt(2 * pi); };
    return {below(end - place) - below(-place), density(place) - density(end - place)};
}

/// A cell of a field in the units of its region.
struct CellInUnits
{
    Place place;
    double sigma, under;
    Place pull; ///< per step and squared mean distance
};

CellInUnits in_units(const RegionField& cells, const FixedRegion& region, const GaussianField& field, double mean,
                     int x, int y)
{
    const GaussianField::Cell& cell = field.cell(x, y);
    const double side = cells.side(), unit = region.unit();
    const auto at = [&](std::size_t k, int number) {
        return (cells.low()[k] + (number + 0.5) * side / field.shape.size) * unit + region.box().low[k];
    };
    const double sigma = std::sqrt(-0.5 * std::numbers::log2e / double{cell.exponent}) * 0x1p-32 * side * unit;
    const double to_units = side * unit / (2 * pi * std::pow(sigma / mean, 4) * mean * mean);
    return {{at(0, x), at(1, y)},
            sigma,
            1 + double{cell.excess} / (2 * pi),
            {double{cell.x} * to_units, double{cell.y} * to_units}};
}

class FieldsOfStrips : public testing::TestWithParam<std::tuple<double, double>>
{
};

/// Sums over cells a quarter of a Gaussian wide stand for integrals: whole cells are off by h^2 / 24 of second
/// derivatives, and what partial ones have is at their middles, which is off by h^2 / 8 of first derivatives along the
/// boundary: below 0.006 altogether, and below 0.015 for slopes.
TEST_P(FieldsOfStrips, HaveTheWidthsAndPullsOfClosedForms)
{
    const auto [degrees, width] = GetParam();
    const Strip strip{60, width, degrees};
    const FixedRegion region = strip.region();
    const auto points = static_cast<std::size_t>(60 * width); // spaced like 1
    const double mean = std::sqrt(60 * width / static_cast<double>(points));
    const RegionField cells(region, points, 1);
    const GaussianField field = cells.field(1);
    int looked_at = 0;
    double least = 1e9;
    for (std::uint32_t row = 0; row < field.shape.grid_size; ++row)
        for (std::uint32_t n = field.listed.row_starts[row]; n < field.listed.row_starts[row + 1]; ++n)
            for (int i = 0; i < 64; ++i) {
                const int x = static_cast<int>(field.listed.columns[n]) * 8 + i % 8,
                          y = static_cast<int>(row) * 8 + i / 8;
                const CellInUnits cell = in_units(cells, region, field, mean, x, y);
                const Place at = strip.within(cell.place);
                const auto expected_under = [&](double squared) {
                    const double sigma = mean * std::sqrt(squared);
                    return squared * blurred_interval(at[0], strip.length, sigma)[0] *
                           blurred_interval(at[1], strip.width, sigma)[0];
                };
                const double squared = cell.sigma * cell.sigma / mean / mean;
                if (at[0] > 0 && at[0] < strip.length && at[1] > 0 && at[1] < strip.width) {
                    ASSERT_EQ(field.cell(x, y).is_empty, 0);
                    least = std::min(least, cell.sigma / mean);
                }
                if (squared > 60) continue; // the widest ones are far from the strip
                ++looked_at;
                if (std::abs(squared / std::exp2(std::round(std::log2(squared))) - 1) > 1e-3) {
                    // It lies between two widths, the narrower of which has too little under it.
                    const double narrower = std::exp2(std::floor(std::log2(squared)));
                    ASSERT_LT(expected_under(narrower), 0.25 + 0.006 * narrower);
                    ASSERT_GT(expected_under(2 * narrower), 0.25 - 0.012 * narrower);
                    ASSERT_NEAR(cell.under, 0.25, 1e-6);
                    continue;
                }
                ASSERT_NEAR(cell.under, expected_under(squared), 0.006 * squared) << at[0] << ' ' << at[1];
                ASSERT_GT(cell.under, 0.2499);
                const Place along = blurred_interval(at[0], strip.length, cell.sigma);
                const Place across = blurred_interval(at[1], strip.width, cell.sigma);
                const Place slope = strip.placed(along[1] * across[0], along[0] * across[1]);
                for (std::size_t k = 0; k < 2; ++k) ASSERT_NEAR(cell.pull[k], slope[k], 0.015) << at[0] << ' ' << at[1];
            }
    EXPECT_GT(looked_at, 900 * width);
    EXPECT_GE(least, 0.999);
}

INSTANTIATE_TEST_SUITE_P(All, FieldsOfStrips,
                         testing::Combine(testing::Values(0.0, 30.0, 63.0, 90.0), testing::Values(0.4, 1.3, 7.0)));

/// All cells of the grid, listed.
GaussianField with_all_listed(const GaussianField& field)
{
    GaussianField all = field;
    all.listed = {{0}, {}};
    all.cells.clear();
    const int size = static_cast<int>(field.shape.grid_size);
    for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
            all.listed.columns.push_back(static_cast<std::uint32_t>(column));
            for (int i = 0; i < 64; ++i) all.cells.push_back(field.cell(column * 8 + i % 8, row * 8 + i / 8));
        }
        all.listed.row_starts.push_back(static_cast<std::uint32_t>(all.listed.columns.size()));
    }
    all.shape.listed = static_cast<std::uint32_t>(all.listed.columns.size());
    return all;
}

/// The whole square, row by row.
GaussianField without_list(const GaussianField& field)
{
    GaussianField all{field.shape, {}};
    all.shape.listed = 0;
    const int size = static_cast<int>(field.shape.size);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) all.cells.push_back(field.cell(column, row));
    return all;
}

/// The widest Gaussians reach over many rows of cells, and sums are those of the same neighbours in one order.
TEST(ListedFields, MakeSetsThatDoNotDependOnTheListNorOnWorkGroups)
{
    Device device = Device::open();
    for (const double width : {0.05, 4.0}) {
        const Strip strip{50, width, 30};
        const FixedRegion region = strip.region();
        const std::size_t count = 150;
        const RegionField cells(region, count, 1);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> part(0.01, 0.99);
        PointSet points{2, {}};
        for (std::size_t i = 0; i < count; ++i) {
            const Place place = strip.placed(50 * part(random), width * part(random));
            for (std::size_t k = 0; k < 2; ++k)
                points.coordinates.push_back(((place[k] - region.box().low[k]) / region.unit() - cells.low()[k]) /
                                             cells.side());
        }
        const double step = usual_gaussian_step(1, 2);
        const GaussianField field = cells.field(step);
        EXPECT_GT(field.shape.listed, 0U);
        const auto request = [&](GaussianField made) {
            return GaussianRequest{30, 1, step, std::make_shared<const GaussianField>(std::move(made))};
        };
        const PointSet expected = reference::descend(points, request(field)).points;
        EXPECT_NE(expected, points);
        for (const std::size_t group : {1U, 7U, 64U})
            EXPECT_EQ(GaussianBlueNoise(device, group).descend(points, request(field)).points, expected);
        for (const GaussianField& other : {with_all_listed(field), without_list(field)}) {
            EXPECT_EQ(reference::descend(points, request(other)).points, expected);
            EXPECT_EQ(GaussianBlueNoise(device).descend(points, request(other)).points, expected);
        }
    }
}

/// The number of cells for each point has a limit, however thin a strip is.
TEST(ListedFields, AreAsLargeAsTheirPoints)
{
    for (const double width : {3.0, 0.3, 1e-2})
        for (const double degrees : {0.0, 30.0}) {
            const Strip strip{1000 / width, width, degrees};
            EXPECT_LT(RegionField(strip.region(), 1000, 1).shape().listed, 4 * 1000 + 1025U) << width;
        }
}

/// Sizes are known before the region is read, which takes time and memory.
TEST(ListedFields, TellTheirSizesFirst)
{
    const FixedRegion region = Strip{1000, 1, 30}.region();
    GaussianFieldShape told;
    const auto tell = [&](bool go_on) {
        return [&told, go_on](const GaussianFieldShape& shape) { return told = shape, go_on; };
    };
    const std::uint32_t listed = RegionField(region, 1000, 1).shape().listed;
    for (const bool go_on : {true, false}) {
        EXPECT_EQ(RegionField(region, 1000, 1, tell(go_on)).shape().listed, listed);
        EXPECT_EQ(told.listed, listed);
    }
}

TEST(ListedFields, AreRefusedWhereMarginsLeaveNothing)
{
    const FixedRegion region(read_region("rectangle 0 0 1000 1"), 0.49999999 * 0.0005);
    EXPECT_THAT(message_of([&] { RegionField(region, 1000, 1); }),
                testing::HasSubstr("too little is left by obstacles and the boundary"));
}

}
}
