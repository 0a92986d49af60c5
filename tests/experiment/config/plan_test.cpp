#include "experiment/config/plan.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using ::testing::ElementsAre;

std::vector<SeriesPlan> plan_of(const std::string& methods)
{
    return make_plan(parse_config("[analysis]\npoints = 256\nrealizations = 4\n" + methods, "c.toml"));
}

std::vector<std::string> names(const std::vector<SeriesPlan>& plan)
{
    std::vector<std::string> result;
    for (const SeriesPlan& series : plan) result.push_back(series.name);
    return result;
}

std::vector<std::string> labels(const std::vector<SeriesPlan>& plan)
{
    std::vector<std::string> result;
    for (const SeriesPlan& series : plan) result.push_back(series.label);
    return result;
}

TEST(Plan, AListMakesOneSeriesAValue)
{
    const auto plan = plan_of("[[method]]\nsampler = \"random\"\n"
                              "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = [0.70, 0.75]\n");
    EXPECT_THAT(names(plan), ElementsAre("random", "dart-throwing-rho-0.70", "dart-throwing-rho-0.75"));
    EXPECT_THAT(labels(plan), ElementsAre("Random", "Dart throwing, rho = 0.70", "Dart throwing, rho = 0.75"));
    EXPECT_EQ(plan[1].parameters.number("relative_radius"), 0.7);
    EXPECT_EQ(plan[1].request.points, 256U);
    EXPECT_EQ(plan[1].request.seed, 1U);
    EXPECT_EQ(plan[1].realizations, 4U);
}

TEST(Plan, SeveralListsMakeTheirProduct)
{
    const auto plan = plan_of("[[method]]\nsampler = \"dart-throwing\"\nlabel = \"Maximal\"\n"
                              "stop = [\"saturation\"]\nmin_distance = [0.1, 0.2, 0.3]\n");
    EXPECT_THAT(labels(plan), ElementsAre("Maximal, d = 0.1", "Maximal, d = 0.2", "Maximal, d = 0.3"))
        << "a user's label and what varies";
    EXPECT_EQ(plan[2].parameters.text("stop"), "saturation");
}

/// A sampler with three parameters, to see products of lists whatever real samplers have.
TEST(Plan, InProductsTheLastParameterVariesFastest)
{
    SamplerSpec spec = *find_sampler("random");
    for (const char* key : {"a", "b", "c"}) {
        ParameterSpec parameter;
        parameter.key = key;
        parameter.maximum = 9;
        spec.parameters.push_back(parameter);
    }
    spec.check = nullptr;
    const auto choice = [](double value) { return ParameterChoice{value, std::to_string(int(value)), {}, {}}; };
    MethodConfig method;
    method.sampler = &spec;
    method.settings = {{&spec.parameters[0], {choice(1), choice(2)}},
                       {&spec.parameters[1], {choice(3)}},
                       {&spec.parameters[2], {choice(4), choice(5)}}};
    Config config;
    config.methods = {method};
    EXPECT_THAT(names(make_plan(config)),
                ElementsAre("random-a-1-b-3-c-4", "random-a-1-b-3-c-5", "random-a-2-b-3-c-4", "random-a-2-b-3-c-5"));
    config.methods[0].label = "L";
    EXPECT_THAT(labels(make_plan(config)),
                ElementsAre("L, a = 1, c = 4", "L, a = 1, c = 5", "L, a = 2, c = 4", "L, a = 2, c = 5"));
}

TEST(Plan, SeriesKnowTheirPlacesInTheGridsOfTheirMethods)
{
    const Config config =
        parse_config("[[method]]\nsampler = \"random\"\n"
                     "[[method]]\nsampler = \"lloyd\"\nlabel = \"L\"\npoints = [64, 128]\n"
                     "iterations = 2\nrepulsion = [false, true]\nuntil_relative_radius = 0.70\n"
                     "start = [\"random\", { sampler = \"dart-throwing\", relative_radius = [0.6, 0.7] }]\n",
                     "c.toml");
    const auto plan = make_plan(config);
    ASSERT_EQ(plan.size(), 1U + 2 * 3 * 2);
    EXPECT_EQ(plan[0].place->method, 0U);
    EXPECT_THAT(plan[0].place->indices, ElementsAre());

    const auto grids = method_grids(config);
    ASSERT_EQ(grids.size(), 2U);
    EXPECT_EQ(grids[0].sampler, "random");
    EXPECT_TRUE(grids[0].axes.empty());
    EXPECT_EQ(grids[1].sampler, "lloyd");
    EXPECT_EQ(grids[1].label, "L");
    ASSERT_EQ(grids[1].axes.size(), 3U) << "lists of at least two values only";
    EXPECT_EQ(grids[1].axes[0].key, "points");
    EXPECT_EQ(grids[1].axes[0].symbol, "N");
    EXPECT_THAT(grids[1].axes[0].values, ElementsAre("64", "128"));
    // Every place is there once, the last axis fastest, and says the values that the series has.
    std::size_t series = 1;
    for (std::size_t i = 0; i < grids[1].axes[0].values.size(); ++i)
        for (std::size_t j = 0; j < grids[1].axes[1].values.size(); ++j)
            for (std::size_t k = 0; k < grids[1].axes[2].values.size(); ++k, ++series) {
                EXPECT_EQ(plan[series].place->method, 1U);
                EXPECT_THAT(plan[series].place->indices, ElementsAre(i, j, k));
                EXPECT_EQ(std::to_string(plan[series].request.points), grids[1].axes[0].values[i]);
            }
    // Axes are in the order of the sampler's parameters; tables make a value of each of their own combinations.
    const auto axis = [&](const char* key) { return std::ranges::find(grids[1].axes, key, &MethodAxis::key)->values; };
    EXPECT_THAT(axis("start"), ElementsAre("Random", "Dart throwing (rho = 0.6)", "Dart throwing (rho = 0.7)"));
    EXPECT_THAT(axis("repulsion"), ElementsAre("false", "true"));
}

TEST(Plan, AMethodCanHaveItsOwnNumberOfPoints)
{
    const auto plan = plan_of("[[method]]\nsampler = \"random\"\n"
                              "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.7\n"
                              "points = [64, 1_024]\n"
                              "[[method]]\nsampler = \"jittered\"\nlabel = \"J\"\npoints = 100\n");
    EXPECT_THAT(names(plan),
                ElementsAre("random", "dart-throwing-N-64-rho-0.7", "dart-throwing-N-1024-rho-0.7", "jittered-N-100"));
    EXPECT_THAT(labels(plan),
                ElementsAre("Random", "Dart throwing, N = 64, rho = 0.7", "Dart throwing, N = 1024, rho = 0.7", "J"));
    EXPECT_EQ(plan[0].request.points, 256U);
    EXPECT_EQ(plan[1].request.points, 64U);
    EXPECT_EQ(plan[2].request.points, 1024U);
    EXPECT_EQ(plan[3].request.points, 100U);
    EXPECT_FALSE(plan[1].parameters.is_given("points")) << "samplers find it in the request";
}

TEST(Plan, ChecksSeeTheMethodsOwnPoints)
{
    // 20,000 points saturate below 0.79; of 64, some sets reach it.
    const std::string method = "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.79\npoints = ";
    EXPECT_EQ(plan_of(method + "64\n").size(), 1U);
    EXPECT_THROW(plan_of(method + "20000\n"), InputError);
}

TEST(Plan, NumbersAreShownAsTypedWherePlain)
{
    const auto plan = plan_of("[[method]]\nsampler = \"dart-throwing\"\n"
                              "relative_radius = [0.700, 5e-1, +0.25, 0.1_5, 1_0e-2]\n");
    EXPECT_THAT(names(plan), ElementsAre("dart-throwing-rho-0.700", "dart-throwing-rho-5e-1", "dart-throwing-rho-0.25",
                                         "dart-throwing-rho-0.15", "dart-throwing-rho-0.1"));
}

TEST(Plan, DeterministicMethodsHaveOneRealization)
{
    EXPECT_EQ(plan_of("[[method]]\nsampler = \"regular\"\n")[0].realizations, 1U);
}

TEST(Plan, FilesHaveAsManyRealizationsAsThereAre)
{
    const TemporaryFolder folder;
    folder.write("a.dat", "0.1 0.2\n#\n0.3 0.4\n");
    folder.write("b.dat", "0.5 0.6\n");
    const auto file = folder.write("c.toml", "[[method]]\nsampler = \"file\"\npath = [\"a.dat\", \"b.dat\"]\n");
    const auto plan = make_plan(read_config(file));
    ASSERT_EQ(plan.size(), 1U);
    EXPECT_EQ(plan[0].realizations, 3U);
    EXPECT_EQ(plan[0].name, "file-path-a");
}

TEST(Plan, NamesThatWouldBeEqualGetNumbers)
{
    const TemporaryFolder folder;
    folder.write("a/x y.dat", "0.1 0.2\n");
    folder.write("b/x-y.dat", "0.3 0.4\n");
    const auto file = folder.write("c.toml", "[[method]]\nsampler = \"file\"\npath = \"a/x y.dat\"\n"
                                             "[[method]]\nsampler = \"file\"\npath = \"b/x-y.dat\"\n");
    EXPECT_THAT(names(make_plan(read_config(file))), ElementsAre("file-path-x-y", "file-path-x-y-2"));
}

TEST(SafeName, IsAFolderNameAnywhere)
{
    EXPECT_EQ(safe_name("dart-throwing-rho-0.70"), "dart-throwing-rho-0.70");
    EXPECT_EQ(safe_name("../../etc"), "etc");
    EXPECT_EQ(safe_name("a b/c\\d:e"), "a-b-c-d-e");
    EXPECT_EQ(safe_name("ρ = 0.7"), "0.7");
    EXPECT_EQ(safe_name(""), "series");
    EXPECT_EQ(safe_name("..."), "series");
}

/// [analysis] region holds for all methods, [[method]] region for one.
TEST(Plan, MethodsLieInTheRegionOfTheAnalysisOrTheirOwn)
{
    const auto plan = make_plan(parse_config("[analysis]\npoints = 256\nregion = \"disk 5 5 3\"\nenvelope = 7\n"
                                             "[[method]]\nsampler = \"random\"\n"
                                             "[[method]]\nsampler = \"random\"\nregion = \"rectangle 0 0 8 2\"\n"
                                             "[[method]]\nsampler = \"bridson\"\nmin_distance = [2, 3]\n",
                                             "c.toml"));
    EXPECT_THAT(names(plan), ElementsAre("random", "random-2", "bridson-d-2", "bridson-d-3"));
    EXPECT_THAT(labels(plan), ElementsAre("Random", "Random in rectangle 0 0 8 2", "Bridson's dart throwing, d = 2",
                                          "Bridson's dart throwing, d = 3"));
    EXPECT_EQ(plan[0].request.region->name(), "disk 5 5 3");
    EXPECT_EQ(plan[1].request.region->name(), "rectangle 0 0 8 2");
    EXPECT_EQ(plan[1].request.region->own_area(), 16);
    EXPECT_EQ(plan[1].region->envelope, 7U);
    EXPECT_EQ(plan[3].request.region, plan[0].request.region);
    const auto mixed = plan_of("[[method]]\nsampler = \"random\"\n"
                               "[[method]]\nsampler = \"random\"\nregion = \"rectangle 0 0 8 2\"\n");
    EXPECT_EQ(mixed[0].request.region, nullptr);
    EXPECT_EQ(mixed[1].region->envelope, 39U);
    EXPECT_THROW(plan_of("[[method]]\nsampler = \"random\"\nregion = \"rectangle 0 0 8 2\"\n"
                         "[[method]]\nsampler = \"random\"\nlabel = \"r\"\nregion = \"rectangle 0 0 8 2\"\n"),
                 InputError);
}

/// --set takes the keys of samplers in regions where there is one.
TEST(Plan, OverridesKnowTheRegion)
{
    const std::string config = "[analysis]\nregion = \"disk 5 5 3\"\n[[method]]\nsampler = \"dart-throwing\"\n"
                               "relative_radius = 0.5\n";
    const auto plan = make_plan(parse_config(config, "c.toml", {"method.boundary=disks"}));
    EXPECT_EQ(plan.at(0).parameters.text("boundary"), "disks");
    const std::string torus = "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.5\n";
    EXPECT_NO_THROW(parse_config(torus, "c.toml", {"method.boundary=disks", "analysis.region=disk 5 5 3"}));
    EXPECT_THROW(parse_config(torus, "c.toml", {"method.boundary=disks"}), InputError);
    EXPECT_EQ(make_plan(parse_config(torus, "c.toml", {"method.region=disk 5 5 3", "method.boundary=disks"}))
                  .at(0)
                  .parameters.text("boundary"),
              "disks");
}

}
}
