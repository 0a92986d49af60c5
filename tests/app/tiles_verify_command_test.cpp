// poissonlab tiles: what it says of tile sets that are sound, and of those that are not.
#include "tests/support/program.hpp"
#include "tests/tiles/poisson/made_up_tile_sets.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::MatchesRegex;

class TilesCommand : public testing::Test
{
protected:
    Outcome verify(const PoissonTileSet& set, const std::vector<std::string>& options = {}) const
    {
        write_tile_set(folder_.path() / "a.ptiles", set);
        std::vector<std::string> arguments{"tiles", "verify", "a.ptiles"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run_program(folder_.path(), arguments);
    }

    void expect_error(const std::vector<std::string>& arguments, const std::string& message) const
    {
        const Outcome outcome = run_program(folder_.path(), arguments);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_EQ(outcome.error, "poissonlab: error: " + message + "\n");
        EXPECT_EQ(outcome.out, "");
    }

    TemporaryFolder folder_;
    PoissonTileSet set_ = made_up(corner_parameters(2));
    TileCertificate certificate_ = certify(set_);
};

TEST_F(TilesCommand, SummarizesSoundSets)
{
    set_.squared_min_distance = certificate_.squared_min_distance;
    const Outcome outcome = verify(set_);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error, "");
    EXPECT_THAT(outcome.out, MatchesRegex("kind                  corner\n"
                                          "colours               2\n"
                                          "tiles                 16\n"
                                          "points per tile       48\n"
                                          "border                strip\n"
                                          "relative radius       0\\.55.* proven, 0\\.550000 asked for\n"
                                          "minimum distance      0\\.085.* tiles\n"
                                          "stored guarantee      0\\.55.*: what is proven\n"
                                          "largest empty circle  radius at most 0\\..* tiles, .* minimum distances\n"
                                          "equal moments         none but the number of points\n"
                                          "low frequencies       power falls off as frequency\\^2 or faster, .*\n"
                                          "\n"
                                          "points of a tile near      min      mean     max   density\n"
                                          "corners  .*\nedges  .*\ninterior  .*\n"));
}

TEST_F(TilesCommand, SpeaksOfOtherKinds)
{
    const Outcome sphere = verify(made_up(sphere_parameters(2)));
    EXPECT_EQ(sphere.status, 0);
    for (const char* words : {"sphere\n", "stored guarantee      none\n", "largest empty sphere  ", "\nfaces  "})
        EXPECT_THAT(sphere.out, HasSubstr(words));
    const Outcome frame = verify(made_up(template_parameters(3)));
    EXPECT_EQ(frame.status, 0);
    EXPECT_THAT(frame.out, HasSubstr("template\ntiles                 3\n"));
}

TEST_F(TilesCommand, PrintsJson)
{
    set_.squared_min_distance = certificate_.squared_min_distance - 1;
    const Outcome outcome = verify(set_, {"--json"});
    ASSERT_EQ(outcome.status, 0);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["file"], "a.ptiles");
    EXPECT_EQ(json["kind"], "corner");
    EXPECT_EQ(json["squared_min_distance"], certificate_.squared_min_distance);
    EXPECT_EQ(json["stored_squared_min_distance"], certificate_.squared_min_distance - 1);
    EXPECT_EQ(json["relative_radius"], certificate_.relative_radius);
    EXPECT_EQ(json["asked_relative_radius"], 0.55);
    EXPECT_EQ(json["largest_empty_radius"], certificate_.largest_empty_radius);
    EXPECT_EQ(json["regions"].size(), 3U);
    EXPECT_EQ(json["regions"]["edges"]["mean"], certificate_.regions[1].mean);
    EXPECT_EQ(json["regions"]["interior"]["density"], certificate_.regions[2].density);
}

TEST_F(TilesCommand, RefusesPromisesThatAreNotProven)
{
    set_.squared_min_distance = certificate_.squared_min_distance + 1;
    const Outcome more = verify(set_);
    EXPECT_EQ(more.status, 2);
    EXPECT_THAT(more.out, HasSubstr("MORE than is proven"));
    EXPECT_THAT(more.error, MatchesRegex("poissonlab: error: a.ptiles: guarantees a squared minimum distance of "
                                         "[0-9]+: must be at most [0-9]+, which is proven: see the points at "
                                         "\\([-0-9]+, [-0-9]+\\) and \\([-0-9]+, [-0-9]+\\) of tile [0-9]+\n"));

    const PoissonTileSet spread = random_points(template_parameters(1));
    const Outcome less = verify(spread);
    EXPECT_EQ(less.status, 2);
    EXPECT_THAT(less.error, MatchesRegex("poissonlab: error: a.ptiles: relative_radius = 0.55: must be at most "
                                         "0\\.[0-9]+, which is proven: see the points at .* of tile 0\n"));
}

TEST_F(TilesCommand, RefusesFilesThatAreNoTileSets)
{
    expect_error({"tiles", "verify", "no"}, "no: cannot be read: No such file or directory");
    folder_.write("points.dat", "0.5 0.5\n");
    expect_error({"tiles", "verify", "points.dat"}, "points.dat: is no Poisson tile set: neither .ptiles nor JSON");
    std::string bytes = encode_tile_set(set_);
    bytes.back() ^= 1;
    folder_.write("damaged.ptiles", bytes);
    const Outcome damaged = run_program(folder_.path(), {"tiles", "verify", "damaged.ptiles"});
    EXPECT_EQ(damaged.status, 2);
    EXPECT_THAT(damaged.error, HasSubstr("damaged.ptiles: is damaged: its checksum is "));
}

TEST_F(TilesCommand, RefusesTilesThatDoNotFitTogether)
{
    // Random tiles: nothing is shared.
    const Outcome outcome = verify(random_points(corner_parameters(2)));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, MatchesRegex("poissonlab: error: a.ptiles: tile [0-9]+: points near its corner .*"));
    EXPECT_EQ(outcome.out, "");
}

TEST_F(TilesCommand, WrongArguments)
{
    expect_error({"tiles"}, "tiles: needs one of build, points, picture, page, verify (see poissonlab tiles --help)");
    expect_error({"tiles", "verify"}, "tiles verify: needs FILE (see poissonlab tiles verify --help)");
    EXPECT_EQ(run_program(folder_.path(), {"tiles", "verfy", "a"}).status, 2);
    EXPECT_THAT(run_program(folder_.path(), {"help", "tiles"}).out, HasSubstr("verify"));
    EXPECT_THAT(run_program(folder_.path(), {"tiles", "verify", "--help"}).out, HasSubstr("--json"));
}

}
}
