// Parameters whose values are flags or samplers: `repulsion = true`, `start = { sampler = "...", ... }`.
#include "experiment/config/plan.hpp"
#include "experiment/run/make_experiment.hpp"
#include "tests/experiment/run/relaxing_sampler.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The plan of a config whose only method is "relax" with these lines.
std::vector<SeriesPlan> plan_of(const std::string& lines, const std::vector<std::string>& overrides = {})
{
    return make_plan(
        parse_config("[[method]]\nsampler = \"relax\"\n" + lines + "\n", "c.toml", overrides, registry_with_relax()));
}

std::string error_of(const std::string& lines, const std::vector<std::string>& overrides = {})
{
    return message_of([&] { plan_of(lines, overrides); });
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

const std::string table_or_name = "a sampler's name in quotes, or a table with its parameters such as "
                                  "{ sampler = \"dart-throwing\", relative_radius = 0.7 }";

TEST(Start, IsASamplerWithItsParameters)
{
    const auto plan = plan_of("iterations = 16\n"
                              "start = { sampler = \"dart-throwing\", relative_radius = 0.70 }\n"
                              "repulsion = true");
    ASSERT_EQ(plan.size(), 1U);
    EXPECT_EQ(plan[0].name, "relax-i-16-dart-throwing-rho-0.70-repulsion");
    EXPECT_EQ(plan[0].label, "Relaxation, i = 16, start = Dart throwing (rho = 0.70), repulsion");
    EXPECT_TRUE(plan[0].parameters.flag("repulsion"));
    const SamplerChoice& start = plan[0].parameters.sampler("start");
    EXPECT_EQ(start.spec->name, "dart-throwing");
    EXPECT_EQ(start.parameters.number("relative_radius"), 0.7);
    EXPECT_EQ(to_string(start.parameters.location("relative_radius")), "c.toml:4");
    EXPECT_EQ(to_string(plan[0].parameters.given().at("start").value),
              "{ sampler = dart-throwing, relative_radius = 0.7 }");
}

TEST(Start, ANameAloneIsATableWithNothingElse)
{
    const auto plan = plan_of("start = \"random\"");
    EXPECT_EQ(plan[0].name, "relax-random");
    EXPECT_EQ(plan[0].label, "Relaxation, start = Random");
    EXPECT_TRUE(plan[0].parameters.sampler("start").parameters.given().empty());
}

TEST(Start, CanBeATableOfItsOwn)
{
    EXPECT_THAT(names(plan_of("[method.start]\nsampler = \"dart-throwing\"\nrelative_radius = 0.5")),
                ElementsAre("relax-dart-throwing-rho-0.5"));
}

TEST(Start, ListsMakeOneSeriesAValue)
{
    const auto plan = plan_of("iterations = [1, 2]\nkeep = \"best\"\n"
                              "start = [\"random\", { sampler = \"dart-throwing\", relative_radius = [0.6, 0.7] }]");
    EXPECT_THAT(names(plan),
                ElementsAre("relax-i-1-random-keep-best", "relax-i-1-dart-throwing-rho-0.6-keep-best",
                            "relax-i-1-dart-throwing-rho-0.7-keep-best", "relax-i-2-random-keep-best",
                            "relax-i-2-dart-throwing-rho-0.6-keep-best", "relax-i-2-dart-throwing-rho-0.7-keep-best"));
    EXPECT_THAT(labels(plan_of("label = \"L\"\niterations = 3\n"
                               "start = { sampler = \"dart-throwing\", relative_radius = [0.6, 0.7] }")),
                ElementsAre("L, start = Dart throwing (rho = 0.6)", "L, start = Dart throwing (rho = 0.7)"))
        << "a user's label and what varies";
}

TEST(Start, FlagsAreNamedWhereTheyAreTrue)
{
    const auto plan = plan_of("start = \"random\"\nrepulsion = [false, true]");
    EXPECT_THAT(names(plan), ElementsAre("relax-random", "relax-random-repulsion"));
    EXPECT_THAT(labels(plan), ElementsAre("Relaxation, start = Random", "Relaxation, start = Random, repulsion"));
}

TEST(Start, CanStartFromAnother)
{
    const auto plan = plan_of("start = { sampler = \"relax\", iterations = 2, start = \"random\" }");
    EXPECT_EQ(plan[0].name, "relax-relax-i-2-random");
    EXPECT_EQ(plan[0].label, "Relaxation, start = Relaxation (i = 2, start = Random)");

    std::string deep = "\"random\"";
    for (int i = 0; i < 3; ++i) deep = "{ sampler = \"relax\", start = " + deep + " }";
    EXPECT_EQ(plan_of("start = " + deep).size(), 1U);
    deep = "{ sampler = \"relax\", start = " + deep + " }";
    EXPECT_EQ(error_of("start = " + deep), "c.toml:3: start = \"random\": samplers lie in one another up to 5 deep");
}

TEST(Start, NamesStayUnique)
{
    // Both labels make the folder name relax-random.
    const auto plan = plan_of("start = \"random\"\n[[method]]\nsampler = \"relax\"\nstart = \"random\"\n"
                              "repulsion = false");
    EXPECT_THAT(names(plan), ElementsAre("relax-random", "relax-random-2"));
    EXPECT_EQ(error_of("start = \"random\"\n[[method]]\nsampler = \"relax\"\nstart = { sampler = \"random\" }"),
              "c.toml:4: [[method]]: the series \"Relaxation, start = Random\" is there twice");
}

TEST(Start, IsCheckedLikeAMethod)
{
    const auto start = [](const std::string& value) { return error_of("start = " + value); };
    EXPECT_EQ(start("5"), "c.toml:3: start = 5: must be " + table_or_name);
    EXPECT_EQ(start("true"), "c.toml:3: start = true: must be " + table_or_name);
    EXPECT_EQ(start("[]"), "c.toml:3: start = []: the list is empty; each item must be " + table_or_name);
    EXPECT_EQ(start("\"randm\""),
              "c.toml:3: start = \"randm\": must be one of \"random\", \"regular\", \"jittered\", "
              "\"hexagonal\", \"sobol\", \"halton\", \"best-candidate\", \"bridson\", "
              "\"dart-throwing\", \"relaxation-dart-throwing\", \"voronoi-darts\", \"sector-darts\", \"lloyd\", "
              "\"sample-elimination\", \"farthest-point\", \"gaussian-blue-noise\", "
              "\"target-spectrum\", \"equal-areas\", "
              "\"corner-tiles\", \"edge-tiles\", "
              "\"template-tiles\", \"sphere-tiles\", \"shade-tiles\", \"averaged-tiles\", "
              "\"penrose\", \"dodecagonal\", \"recursive-wang-tiles\", \"polyominoes\", \"isohedral-tiles\", "
              "\"hat-tiles\", \"spectre-tiles\", \"file\", "
              "\"command\", \"relax\"; "
              "did you mean \"random\"?");
    EXPECT_THAT(start("{ sampler = \"dart-throwin\" }"),
                testing::AllOf(HasSubstr("c.toml:3: sampler = \"dart-throwin\": must be one of "),
                               HasSubstr("; did you mean \"dart-throwing\"?")));
    EXPECT_THAT(start("{ relative_radius = 0.7 }"),
                HasSubstr("c.toml:3: start: sampler is missing; it must be one of \"random\", "));
    EXPECT_EQ(start("{ sampler = \"dart-throwing\", relative_radus = 0.7 }"),
              "c.toml:3: relative_radus = 0.7: unknown key; did you mean \"relative_radius\"? "
              "known keys: sampler, relative_radius, stop, min_distance");
    EXPECT_EQ(start("{ sampler = \"random\", label = \"x\" }"),
              "c.toml:3: label = \"x\": unknown key; known keys: sampler");
    EXPECT_EQ(start("{ sampler = \"dart-throwing\", relative_radius = [0.7,\n 1.5] }"),
              "c.toml:4: relative_radius = 1.5: must be a number greater than 0 and at most 1");
    EXPECT_EQ(start("\"dart-throwing\""),
              "c.toml:3: sampler = \"dart-throwing\": needs relative_radius, or stop = \"saturation\"");
    EXPECT_EQ(start("{ sampler = \"random\", points = 4 }"), "c.toml:3: points = 4: unknown key; known keys: sampler")
        << "as many as its method has";
    EXPECT_THAT(start("{ sampler = \"dart-throwing\", relative_radius = 0.95 }"),
                HasSubstr("c.toml:3: relative_radius = 0.95: "));
    EXPECT_EQ(error_of("start = { sampler = \"relax\" }"), "c.toml:3: start is missing");
}

TEST(Start, FlagsAreTrueOrFalse)
{
    for (const char* value : {"1", "\"true\"", "0.5", "[[true]]"})
        EXPECT_THAT(error_of(std::string("start = \"random\"\nrepulsion = ") + value),
                    testing::EndsWith("must be true or false"));
}

TEST(Start, TooManySeries)
{
    std::string list;
    for (int i = 0; i < 32; ++i) list += std::to_string(i) + ", ";
    EXPECT_EQ(error_of("start = { sampler = \"relax\", iterations = [" + list +
                       "], start = { sampler = \"relax\", iterations = [" + list + "], start = \"random\" } }"),
              "c.toml:3: start: its lists make more than 1000 series");
}

TEST(Start, CanBeSetFromTheCommandLine)
{
    const std::string lines = "start = { sampler = \"dart-throwing\", relative_radius = 0.6 }";
    EXPECT_THAT(names(plan_of(lines, {"method.0.start.relative_radius=0.7", "method.repulsion=true"})),
                ElementsAre("relax-dart-throwing-rho-0.7-repulsion"));
    EXPECT_THAT(names(plan_of(lines, {"method.start.relative_radius=[0.7, 0.5]"})),
                ElementsAre("relax-dart-throwing-rho-0.7", "relax-dart-throwing-rho-0.5"));
    EXPECT_THAT(names(plan_of(lines, {"method.0.start=random"})), ElementsAre("relax-random"));
    EXPECT_THAT(names(plan_of("", {"method.0.start={ sampler = \"random\" }"})), ElementsAre("relax-random"));

    const std::string wrong = "method.0.start.relative_radius=7";
    EXPECT_EQ(error_of(lines, {wrong}), "--set " + wrong +
                                            ": relative_radius = 7: "
                                            "must be a number greater than 0 and at most 1");
    EXPECT_EQ(error_of("start = \"random\"", {"method.0.start.relative_radius=0.7"}),
              "--set method.0.start.relative_radius=0.7: \"start\" is not a table and has no keys");
    EXPECT_EQ(error_of(lines, {"method.repulsion=maybe"}),
              "--set method.repulsion=maybe: repulsion = \"maybe\": must be true or false");
}

TEST(Start, DimensionsAreThoseOfAllSamplers)
{
    SamplerRegistry registry = registry_with_relax();
    for (SamplerSpec& spec : registry)
        if (spec.name == "random") spec.dimensions = {3};
    EXPECT_EQ(message_of([&] {
                  make_plan(
                      parse_config("[[method]]\nsampler = \"relax\"\nstart = \"random\"\n", "c.toml", {}, registry));
              }),
              "c.toml:3: sampler = \"random\": this method has no 2D sets; dimension must be 3");
}

TEST(Start, MethodsOfThePlaneAreRefusedInSpace)
{
    EXPECT_EQ(error_of("start = \"random\"", {"analysis.dimension=3"}),
              "c.toml:1: sampler = \"relax\": this method has no 3D sets; dimension must be 2");
}

TEST(Start, DecidesWhetherRealizationsDiffer)
{
    EXPECT_EQ(plan_of("start = \"random\"")[0].realizations, 10U);
    const auto plan = plan_of("start = { sampler = \"relax\", start = \"regular\" }");
    EXPECT_EQ(plan[0].realizations, 1U);
    EXPECT_TRUE(plan[0].deterministic);
}

TEST(Start, FilesHaveAsManyRealizationsAsThereAre)
{
    const TemporaryFolder folder;
    folder.write("a.dat", "0.1 0.2\n#\n0.3 0.4\n");
    const auto file = folder.write("c.toml", "");
    const Config config =
        parse_config("[[method]]\nsampler = \"relax\"\nstart = { sampler = \"file\", path = \"a.dat\" }\n",
                     file.string(), {}, registry_with_relax());
    const auto plan = make_plan(config);
    EXPECT_EQ(plan[0].name, "relax-file-path-a");
    EXPECT_EQ(plan[0].realizations, 2U);
}

TEST(Start, ReachesTheSampler)
{
    const Config config =
        parse_config("engine = \"reference\"\n[analysis]\npoints = 9\n[[method]]\nsampler = \"relax\"\n"
                     "start = \"regular\"\n",
                     "c.toml", {}, registry_with_relax());
    const Experiment experiment = make_experiment(config, "", 1);
    EXPECT_EQ(experiment.series[0].create()->sample(0).size(), 9U);
}

}
}
