// Runs of tile sets and tilings: what is stored, and that the numbers tell good hash functions from bad ones.
#include "base/images/square_image.hpp"
#include "tests/support/program.hpp"
#include "tiles/tilings/tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class TilingRun : public testing::Test
{
protected:
    /// results.json of a run of a config.
    json results(const std::string& config)
    {
        folder_.write("c.toml", config);
        const Outcome outcome = run_program(folder_.path(), {"run", "c.toml", "--out", "out"});
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return json::parse(content_of(out_ / "results.json"));
    }

    TemporaryFolder folder_;
    fs::path out_ = folder_.path() / "out";
};

TEST_F(TilingRun, StoresSetsAndTilings)
{
    const json root =
        results("[[tile_set]]\nkind = \"wang\"\ntiles = \"compact\"\n"
                "[[tiling]]\ncolors = 3\nwindow = [-1, 2, 3, 2]\n"
                "[[tiling]]\nkind = \"cube\"\nwindow = [0, 0, 0, 2, 1, 2]\nperiod = [2]\nregions = 0.1\n");
    EXPECT_TRUE(root["series"].empty());
    ASSERT_EQ(root["tilings"].size(), 3);
    const json& set = root["tilings"][0];
    EXPECT_EQ(set["name"], "tile-set-wang-compact-C-2");
    EXPECT_EQ(set["tiles"], 8);
    EXPECT_EQ(set["set"], "compact");
    std::istringstream indices(content_of(out_ / set["file"].get<std::string>()));
    EXPECT_EQ(std::distance(std::istream_iterator<int>(indices), {}), 8);

    const json& tiling = root["tilings"][1];
    EXPECT_EQ(tiling["tiles"], 81);
    EXPECT_EQ(tiling["hash_period"], json({5930659848, 5930659848}));
    const Tiling expected(DirectAlgorithm::corner, {3, 3}, HashKind::long_period, 1);
    std::string text;
    for (const int y : {3, 2})
        for (const int x : {-1, 0, 1}) text += std::to_string(expected.tile(x, y)) + (x == 1 ? "\n" : " ");
    EXPECT_EQ(content_of(out_ / tiling["file"].get<std::string>()), text);

    const json& cubes = root["tilings"][2];
    EXPECT_FALSE(cubes.contains("statistics")) << "it closes";
    EXPECT_EQ(cubes["regions"], 0.1);
    for (const json& each : root["tilings"])
        for (const char* picture : {"tiles.svg", "tiles.png"})
            EXPECT_GT(fs::file_size(out_ / each["name"].get<std::string>() / picture), 300U);
    EXPECT_THAT(content_of(out_ / "index.html"), testing::HasSubstr("1 tile set and 2 tilings."));
}

TEST_F(TilingRun, SeesWhichHashFunctionsRepeat)
{
    const json root = results("[[tiling]]\nhash = \"permutation\"\n[[tiling]]\n[[tiling]]\nkind = \"wang\"\n"
                              "hash = \"xxh64\"\n[[tiling]]\nkind = \"wang\"\nalgorithm = \"scanline\"\n");
    const auto statistics = [&](int i) -> const json& { return root["tilings"][i]["statistics"]; };
    const json& bad = statistics(0)["colors"][0]["autocorrelation"];
    EXPECT_GT(bad["largest"].get<double>(), 100) << "colours are the same again after 256";
    EXPECT_EQ(std::abs(bad["largest_at"][0].get<int>()) % 256, 0);
    EXPECT_EQ(bad["largest_at"][1].get<int>() % 256, 0);
    EXPECT_EQ(root["tilings"][0]["hash_period"], json({256, 256}));
    EXPECT_EQ(bad["agreement"], 1);
    EXPECT_THAT(content_of(out_ / "index.html"),
                testing::AllOf(testing::HasSubstr("these colours repeat"), testing::HasSubstr("no trace of repetition"),
                               testing::Not(testing::HasSubstr("they depend on each other"))));
    for (const int good : {1, 2, 3}) {
        ASSERT_EQ(statistics(good)["colors"].size(), good == 1 ? 1 : 2);
        EXPECT_GT(statistics(good)["tile_frequencies"]["p_value"].get<double>(), 1e-4) << good;
        for (const json& colors : statistics(good)["colors"]) {
            const json& autocorrelation = colors["autocorrelation"];
            EXPECT_LT(autocorrelation["largest"].get<double>(), autocorrelation["bound"].get<double>() + 1) << good;
            EXPECT_GT(colors["frequencies"]["p_value"].get<double>(), 1e-4) << good;
            const auto image = read_square_image(out_ / autocorrelation["file"].get<std::string>());
            EXPECT_EQ(image.size, 641);
            EXPECT_EQ(image.at(320, 320), 0) << "the middle";
        }
    }
}

TEST_F(TilingRun, ComparesColorsOfAperiodicSetsWithTheirOwnFrequencies)
{
    const json root = results("[[tiling]]\nkind = \"wang\"\nalgorithm = \"kari\"\nwindow = [0, 0, 4, 4]\n");
    for (const json& colors : root["tilings"][0]["statistics"]["colors"]) {
        double places = 0, squares = 0;
        for (const double count : colors["counts"]) {
            places += count;
            squares += count * count;
        }
        const json& autocorrelation = colors["autocorrelation"];
        EXPECT_NEAR(autocorrelation["chance"].get<double>(), squares / places / places, 1e-6);
        // Displacements agree more often than by chance, and less often: the mean is that of chance.
        const auto image = read_square_image(out_ / autocorrelation["file"].get<std::string>());
        std::size_t above = 0, below = 0;
        for (int row = 0; row < image.size; ++row)
            for (int column = 0; column < image.size; ++column) ++(image.at(column, row) > 0 ? above : below);
        EXPECT_GT(std::min(above, below), (above + below) / 10) << colors["name"];
        EXPECT_LT(autocorrelation["agreement"].get<double>(), 1) << "they do not repeat";
    }
    EXPECT_THAT(content_of(out_ / "index.html"),
                testing::AllOf(testing::HasSubstr("they depend on each other"),
                               testing::Not(testing::HasSubstr("these colours repeat"))));
}

TEST_F(TilingRun, DoesNotCountTilesOfSetsThatAreTooLarge)
{
    const json root = results("[[tiling]]\ncolors = 251\nhash = \"xxh64\"\nwindow = [0, 0, 2, 2]\n");
    EXPECT_EQ(root["tilings"][0]["tiles"], 251ULL * 251 * 251 * 251);
    EXPECT_FALSE(root["tilings"][0]["statistics"].contains("tile_frequencies"));
    EXPECT_GT(root["tilings"][0]["statistics"]["colors"][0]["frequencies"]["p_value"].get<double>(), 1e-4);
}

TEST_F(TilingRun, GivesTheSameBytesAgain)
{
    const std::string config = "[[tiling]]\nkind = \"wang\"\n[[tile_set]]\n";
    results(config);
    auto first = files_below(out_);
    results(config);
    auto second = files_below(out_);
    for (const char* with_times : {"index.html", "results.json"}) first.erase(with_times), second.erase(with_times);
    EXPECT_EQ(first, second);
}

}
}
