// `poissonlab export` of results that the program made itself.
#include "base/points/point_file.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class ExportCommand : public testing::Test
{
protected:
    ExportCommand()
    {
        folder_.write("c.toml", "engine = \"reference\"\n[analysis]\npoints = 256\nrealizations = 2\n"
                                "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n"
                                "[[method]]\nsampler = \"regular\"\n");
        const Outcome outcome = run_program(folder_.path(), {"run", "c.toml", "--quiet", "--out", "results"});
        EXPECT_EQ(outcome.status, 0) << outcome.error;
    }

    std::size_t count(const char* extension) const
    {
        std::size_t found = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path() / "out"))
            found += entry.path().extension() == extension;
        return found;
    }

    TemporaryFolder folder_;
};

TEST_F(ExportCommand, WritesEveryPlotAndEveryPointSet)
{
    const Outcome outcome = run_program(folder_.path(), {"export", "results", "--out", "out", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(outcome.out, "out\n");
    const auto series = folder_.path() / "out/results/dart-throwing-rho-0.6";
    EXPECT_THAT(content_of(series / "radial.csv"), StartsWith("curve,x,y,low,high,dot\n\"Dart throwing"));
    EXPECT_THAT(content_of(series / "radial.tex"), HasSubstr("\\begin{axis}"));
    EXPECT_EQ(count(".usda"), 3U); // two realizations, and the one of a deterministic method
    EXPECT_EQ(count(".csv"), count(".tex") + 3);
    const auto stored = folder_.path() / "results/dart-throwing-rho-0.6";
    for (const auto& entry : std::filesystem::directory_iterator(stored)) {
        if (entry.path().extension() != ".dat" && entry.path().extension() != ".txt") continue;
        EXPECT_EQ(read_points(series / (entry.path().stem().string() + ".csv")), read_points(entry.path()));
    }
}

TEST_F(ExportCommand, TakesAPart)
{
    ASSERT_EQ(run_program(folder_.path(), {"export", "results", "--out", "out", "--points"}).status, 0);
    EXPECT_EQ(count(".tex"), 0U);
    EXPECT_EQ(count(".usda"), 3U);
    ASSERT_EQ(run_program(folder_.path(), {"export", "results", "--out", "out", "--plots"}).status, 0);
    EXPECT_GT(count(".tex"), 0U);
}

TEST_F(ExportCommand, RefusesFoldersWithoutResults)
{
    folder_.write("empty/nothing.txt", "");
    const Outcome outcome = run_program(folder_.path(), {"export", "empty", "--out", "out"});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out"));
    EXPECT_EQ(run_program(folder_.path(), {"export", "results"}).status, 2);
}

}
TEST_F(ExportCommand, WritesWhatPapersClaimAndWhatWasMeasured)
{
    const Outcome outcome = run_program(folder_.path(), {"export", "results", "--out", "out", "--claims", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    const std::string table = content_of(folder_.path() / "out/claims.csv");
    EXPECT_THAT(table, StartsWith("paper,section,claim,samplers,agreement,says,criterion,measured\n\"Ares Lagae"));
    EXPECT_THAT(table, HasSubstr(",dart-throwing"));
    EXPECT_EQ(count(".tex"), 0U);
}

}
