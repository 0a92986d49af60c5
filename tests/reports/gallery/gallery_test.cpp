// The gallery of reference curves: its tables, and what those that ship say against what is known.
#include "reports/gallery/gallery.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace poissonlab {
namespace {

using testing::HasSubstr;

Curve small_curve()
{
    Curve curve;
    curve.points = 100;
    curve.periodograms = 10;
    for (int k = 1; k <= 5; ++k) curve.bins.push_back({static_cast<double>(k), 0.1 * k, -10.5, 6, 0.01});
    return curve;
}

Series small_series()
{
    Series series;
    series.name = "darts-rho-0.7";
    series.sampler = "dart-throwing";
    series.parameters_json = R"({"relative_radius":0.7,"stop":"points"})";
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
    const auto gallery = read_gallery(gallery_tables({{&series, "Darts, \"rho\" = 0.7", &curve, "7", "0.9 (abc)"}}));
    ASSERT_EQ(gallery.size(), 1u);
    const GalleryMethod& method = gallery[0];
    EXPECT_EQ(method.name, "darts-rho-0.7");
    EXPECT_EQ(method.label, "Darts, \"rho\" = 0.7");
    EXPECT_EQ(method.sampler, "dart-throwing");
    EXPECT_EQ(method.parameters, R"({"relative_radius":0.7,"stop":"points"})");
    EXPECT_EQ(method.seed, "7");
    EXPECT_EQ(method.program, "0.9 (abc)");
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
    const auto gallery =
        read_gallery(gallery_tables({{&series, "Darts", &plane, "1", "0.1"}, {&series, "Darts", &space, "1", "0.1"}}));
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
    const GalleryTables good = gallery_tables({{&series, "Darts", &curve, "1", "0.1"}});
    const auto error_of = [&](auto change) {
        GalleryTables tables = good;
        change(tables);
        return message_of([&] { read_gallery(tables); });
    };
    EXPECT_EQ(error_of([](auto& t) { t.methods = "x\n"; }),
              "methods.csv:1: must be the header "
              "name,dimension,points,realizations,min_distance,sampler,seed,program,parameters,label");
    EXPECT_EQ(error_of([](auto& t) { t.methods += "a,2,100\n"; }), "methods.csv:3: must have 10 columns");
    EXPECT_EQ(error_of([](auto& t) { t.methods += "a,2,100,10,0,x,1,0.1,\"{}\",\"A\n"; }),
              "methods.csv:3: must close its quotes, with a comma behind");
    EXPECT_EQ(error_of([](auto& t) { t.methods += "a,2,100,10,0,x,1,0.1,\"{}\",\"A\"\n"; }),
              "curves.csv: has no curve of a");
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

TEST(Gallery, ChosenMethodsAreThere)
{
    EXPECT_EQ(gallery_choice(2).size(), 9u);
    EXPECT_EQ(gallery_choice(3).size(), 6u);
}

/// The mean over each ring or shell of frequencies of a known power that is the same for f and -f along each axis.
template <class Power>
std::vector<double> expected_powers(const Curve& curve, const Power& power)
{
    const int most = static_cast<int>(curve.bins.size());
    const int depth = curve.dimension == 3 ? most : 0;
    std::vector<double> sums(curve.bins.size()), counts(curve.bins.size());
    // One of those that differ in signs alone stands for all.
    const auto signs = [](int frequency) { return frequency > 0 ? 2 : 1; };
    for (int z = 0; z <= depth; ++z)
        for (int y = 0; y <= most; ++y)
            for (int x = 0; x <= most; ++x) {
                const long ring = std::lround(std::sqrt(x * x + y * y + z * z));
                if (ring < 1 || ring > most) continue;
                const int weight = signs(x) * signs(y) * signs(z);
                sums[static_cast<std::size_t>(ring - 1)] += weight * power(std::array{x, y, z});
                counts[static_cast<std::size_t>(ring - 1)] += weight;
            }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    return sums;
}

/// The squared deviations of a curve from what is expected, in units of its errors, summed. Errors are themselves
/// estimates, of 10 sets: what they divide is distributed as Student's t with 9 degrees of freedom, whose square has
/// the mean 9 / 7 and the deviation 2.3.
void expect_curve(const std::string& name, const std::function<double(std::array<int, 3>)>& power)
{
    const GalleryMethod* method = method_of_gallery(name);
    ASSERT_TRUE(method) << name;
    ASSERT_EQ(method->curve.periodograms, 10);
    const std::vector<double> expected = expected_powers(method->curve, power);
    double squares = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const RadialBin& bin = method->curve.bins[i];
        squares += std::pow((bin.power - expected[i]) / bin.power_error, 2);
    }
    const auto rings = static_cast<double>(expected.size());
    EXPECT_NEAR(squares, rings * 9 / 7, 5 * 2.3 * std::sqrt(rings)) << name;
}

TEST(Gallery, CurvesOfRandomPointsAreFlat)
{
    for (const char* name : {"random", "random-3d"}) expect_curve(name, [](auto) { return 1.0; });
}

/// One uniform point in each cell of a lattice of n along each axis: 1 less the squared transform of a cell, but at
/// multiples of n, where all cells but the one at 0 have none.
TEST(Gallery, CurvesOfJitteredPointsAreKnown)
{
    const auto jittered = [](int cells) {
        return [cells](std::array<int, 3> frequency) {
            double transform = 1;
            for (const int f : frequency) {
                const double x = std::numbers::pi * f / cells;
                if (f != 0) transform *= std::sin(x) / x;
            }
            return 1 - transform * transform;
        };
    };
    expect_curve("jittered", jittered(128));
    expect_curve("jittered-3d", jittered(40));
}

/// All power of a square lattice of n points along each axis is at multiples of n, N at each.
TEST(Gallery, CurvesOfRegularPointsArePeaks)
{
    for (const auto& [name, cells] : {std::pair{"regular", 128}, std::pair{"regular-3d", 40}}) {
        const GalleryMethod* method = method_of_gallery(name);
        ASSERT_TRUE(method) << name;
        const std::vector<double> expected = expected_powers(method->curve, [&](std::array<int, 3> frequency) {
            const bool is_peak = std::ranges::all_of(frequency, [&](int f) { return f % cells == 0; });
            return is_peak ? static_cast<double>(method->curve.points) : 0;
        });
        // Tables have four digits, and what rounding leaves of zeros.
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_NEAR(method->curve.bins[i].power, expected[i], 6e-4 * expected[i] + 1e-9) << name << ", " << i + 1;
    }
}

}
}
