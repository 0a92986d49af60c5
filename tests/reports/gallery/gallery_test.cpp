// The gallery of reference curves: its tables, and what those that ship say against what is known.
#include "reports/gallery/gallery.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

Curve small_curve()
{
    Curve curve;
    curve.points = 100;
    curve.realizations = 10;
    for (int k = 1; k <= 5; ++k) curve.bins.push_back({static_cast<double>(k), 0.1 * k, -10.5, 6, 0.01});
    return curve;
}

Series small_series()
{
    Series series;
    series.name = "darts-rho-0.7";
    series.points = 100;
    series.realizations = 10;
    series.min_distance = Statistic{0.08, 0.08, 0.08, {0.08, 0.08}};
    series.relative_radius = Statistic{0.7, 0.75, 0.8, {0.7, 0.8}};
    series.measures.numbers["effective_nyquist"] = {0.61234567, 0.0123};
    series.sample_seconds = {1};
    return series;
}

TEST(Gallery, ReadsWhatItWrites)
{
    const Curve curve = small_curve();
    const Series series = small_series();
    const auto gallery = read_gallery(gallery_tables({{&series, "Darts, rho = 0.7", &curve}}));
    ASSERT_EQ(gallery.size(), 1u);
    const GalleryMethod& method = gallery[0];
    EXPECT_EQ(method.name, "darts-rho-0.7");
    EXPECT_EQ(method.label, "Darts, rho = 0.7");
    EXPECT_EQ(method.curve.points, 100u);
    EXPECT_EQ(method.curve.dimension, 2);
    EXPECT_DOUBLE_EQ(method.curve.background_db, -10);
    EXPECT_DOUBLE_EQ(*method.curve.principal_frequency, 12.5);
    EXPECT_EQ(method.curve.max_frequency, 5);
    ASSERT_EQ(method.curve.bins.size(), 5u);
    EXPECT_DOUBLE_EQ(method.curve.bins[2].power, 0.3);
    EXPECT_DOUBLE_EQ(method.curve.bins[2].power_error, 0.01);
    EXPECT_DOUBLE_EQ(method.curve.bins[2].anisotropy_db, -10.5);
    EXPECT_DOUBLE_EQ(method.measures.at("effective_nyquist").value, 0.61235);
    EXPECT_DOUBLE_EQ(*method.measures.at("effective_nyquist").standard_error, 0.012);
    // The deviation of two sets with 0.7 and 0.8 is 0.0707; their mean has it over the root of two.
    EXPECT_DOUBLE_EQ(*method.measures.at("relative_radius").standard_error, 0.05);
    EXPECT_FALSE(method.measures.contains("sample_time")) << "times are those of a machine";
    EXPECT_FALSE(method.measures.contains("realizations"));
}

TEST(Gallery, TellsDimensionsApart)
{
    const Curve plane = small_curve();
    Curve space = plane;
    space.dimension = 3;
    const Series series = small_series();
    const auto gallery = read_gallery(gallery_tables({{&series, "Darts", &plane}, {&series, "Darts", &space}}));
    ASSERT_EQ(gallery.size(), 2u);
    EXPECT_EQ(gallery[0].name, "darts-rho-0.7");
    EXPECT_EQ(gallery[1].name, "darts-rho-0.7-3d");
    EXPECT_EQ(gallery[1].curve.dimension, 3);
    EXPECT_EQ(gallery[1].curve.bins.size(), plane.bins.size());
}

TEST(Gallery, MistakesAreSaidWithTableAndLine)
{
    const Curve curve = small_curve();
    const Series series = small_series();
    const GalleryTables good = gallery_tables({{&series, "Darts", &curve}});
    const auto error_of = [&](auto change) {
        GalleryTables tables = good;
        change(tables);
        return message_of([&] { read_gallery(tables); });
    };
    EXPECT_EQ(error_of([](auto& t) { t.methods = "x\n"; }),
              "methods.csv:1: must be the header name,dimension,points,realizations,min_distance,label");
    EXPECT_EQ(error_of([](auto& t) { t.methods += "a,2,100\n"; }), "methods.csv:3: must have 6 columns");
    EXPECT_EQ(error_of([](auto& t) { t.methods += "a,2,100,10,0,A\n"; }), "methods.csv:3: the label must be in quotes");
    EXPECT_EQ(error_of([](auto& t) { t.methods += "a,2,100,10,0,\"A\"\n"; }), "curves.csv: has no curve of a");
    EXPECT_THAT(error_of([](auto& t) { t.measures += "b,oscillation,1,\n"; }),
                HasSubstr("b is no method of methods.csv"));
    EXPECT_THAT(error_of([](auto& t) { t.curves += "darts-rho-0.7,6,x,0,0\n"; }),
                HasSubstr("curves.csv:7: \"x\" must be a number"));
}

const GalleryMethod* method_of_gallery(const std::string& name)
{
    for (const GalleryMethod& method : reference_gallery())
        if (method.name == name) return &method;
    return nullptr;
}

/// A measure of a method that must be there, with its error.
Estimate shipped(const std::string& method, const std::string& measure)
{
    const GalleryMethod* found = method_of_gallery(method);
    if (!found) ADD_FAILURE() << "the gallery has no " << method;
    return found ? found->measures.at(measure) : Estimate{};
}

/// Published numbers; tolerances are five standard errors, and half of the last published digit.
TEST(Gallery, HasThePublishedNumbers)
{
    const auto expect_published = [](const char* method, const char* measure, double published, double half_digit) {
        const Estimate value = shipped(method, measure);
        EXPECT_NEAR(value.value, published, 5 * value.standard_error.value_or(0) + half_digit)
            << method << ", " << measure;
    };
    // Clark and Evans 1954: half a mean spacing, over sqrt(2 / sqrt 3).
    expect_published("random", "mean_nearest_distance", 0.46530, 5e-6);
    // Zhang and Torquato 2013.
    expect_published("dart-throwing-stop-saturation", "low_frequency_intercept", 0.0587, 5e-5);
    // The set of 4,096 points by dart throwing at 0.75 that UTK publishes.
    expect_published("dart-throwing-rho-0.75", "mean_nearest_distance", 0.806, 0.003);
    EXPECT_NEAR(shipped("hexagonal", "relative_radius").value, 1, 0.01) << "of about as many points";
    EXPECT_NEAR(shipped("hexagonal-3d", "relative_radius").value, 1, 0.01) << "of about as many points";
    EXPECT_GE(shipped("corner-tiles-C-4", "relative_radius").value, 0.75) << "which tilings are proven to have";
    if (method_of_gallery("farthest-point")) {
        expect_published("farthest-point", "relative_radius", 0.925, 0.001);
        expect_published("farthest-point", "mean_nearest_distance", 0.932, 0.002);
    }
}

TEST(Gallery, CurvesOfRandomPointsAreFlat)
{
    const GalleryMethod* random = method_of_gallery("random");
    ASSERT_TRUE(random);
    // Each ring has the variance that its error says. Errors are themselves estimates, of 10 sets: what they divide is
    // distributed as Student's t with 9 degrees of freedom, whose square has the mean 9 / 7 and the deviation 2.3.
    double squares = 0;
    for (const RadialBin& bin : random->curve.bins) squares += std::pow((bin.power - 1) / bin.power_error, 2);
    const auto rings = static_cast<double>(random->curve.bins.size());
    EXPECT_NEAR(squares, rings * 9 / 7, 5 * 2.3 * std::sqrt(rings));
}

}
}
