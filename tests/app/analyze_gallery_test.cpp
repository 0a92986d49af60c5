// `poissonlab analyze --gallery`: reference curves behind somebody's set.
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string random_text(std::size_t points)
{
    std::mt19937_64 random(2);
    std::string text;
    for (std::size_t i = 0; i < points; ++i)
        text += fmt::format("{:.9f} {:.9f}\n", std::uniform_real_distribution()(random),
                            std::uniform_real_distribution()(random));
    return text;
}

TEST(AnalyzeGallery, LaysReferenceCurvesBehindASet)
{
    const TemporaryFolder folder;
    folder.write("mine.dat", random_text(500));
    const Outcome outcome = run_program(folder.path(), {"analyze", "mine.dat", "--gallery", "--out", "o"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto page = content_of(folder.path() / "o/index.html");
    for (const char* words : {"Beside the gallery", "Sample elimination", "Dart throwing, ρ = 0.75",
                              "Effective Nyquist", "Methods without preferred directions that are better than mine",
                              " methods are better, the best is Farthest point"})
        EXPECT_THAT(page, HasSubstr(words));
    for (const char* stem : {"radial-gallery", "structure-factor-gallery", "anisotropy-gallery"}) {
        const auto plot = content_of(folder.path() / "o" / (std::string(stem) + ".svg"));
        EXPECT_THAT(plot, HasSubstr(">Sample elimination<"));
        EXPECT_THAT(plot, Not(HasSubstr(">Isohedral tiles<"))) << "which is none of those that are chosen";
    }
    const auto compare = content_of(folder.path() / "o/compare.html");
    for (const char* words : {"Gallery of reference curves", "Sample elimination", "Isohedral tiles"})
        EXPECT_THAT(compare, HasSubstr(words));
    const Outcome again = run_program(folder.path(), {"report", "o", "--gallery", "--out", "o"});
    EXPECT_EQ(again.status, 0) << again.error;
    EXPECT_THAT(content_of(folder.path() / "o/index.html"), HasSubstr("Beside the gallery"));
}

TEST(AnalyzeGallery, IsOnTheComparePageOnlyWhereNobodyAsksForMore)
{
    const TemporaryFolder folder;
    folder.write("mine.dat", random_text(300));
    const Outcome outcome = run_program(folder.path(), {"analyze", "mine.dat", "--out", "o"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(content_of(folder.path() / "o/index.html"), Not(HasSubstr("Beside the gallery")));
    EXPECT_THAT(content_of(folder.path() / "o/compare.html"), HasSubstr("Gallery of reference curves"));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "o/radial-gallery.svg"));
}

TEST(ExportGallery, MakesTablesOfARun)
{
    const TemporaryFolder folder;
    folder.write("c.toml", "[analysis]\npoints = 200\nrealizations = 2\n[[method]]\nsampler = \"random\"\n");
    ASSERT_EQ(run_program(folder.path(), {"run", "c.toml"}).status, 0);
    const Outcome outcome = run_program(folder.path(), {"export", "out/c", "--gallery", "--out", "g"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const auto methods = content_of(folder.path() / "g/methods.csv");
    EXPECT_THAT(methods, HasSubstr("\nrandom,2,200,2,"));
    EXPECT_THAT(methods, HasSubstr(",random,1,")) << "the sampler and the seed";
    EXPECT_THAT(methods, HasSubstr(",\"{}\",\"Random\"\n"));
    EXPECT_THAT(content_of(folder.path() / "g/measures.csv"), HasSubstr("\nrandom,mean_nearest_distance,"));
    EXPECT_THAT(content_of(folder.path() / "g/curves.csv"), HasSubstr("\nrandom,1,"));
    const Outcome twice = run_program(folder.path(), {"export", "out/c", "out/c", "--gallery", "--out", "h"});
    EXPECT_EQ(twice.status, 2);
    EXPECT_THAT(twice.error, HasSubstr("the series random is there twice"));
}

}
}
