// The member "tilings" of results.json, whole and damaged.
#include "results/pictures/stored_tiles.hpp"

#include "base/files/json_members.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

class TilingResults : public testing::Test
{
protected:
    TilingResults()
    {
        folder_.write("tiles.txt", "1 80 3\n4 5 6\n");
        folder_.write("a.exr", "");
    }

    std::vector<TilingResult> read() const
    {
        const json root = {{"tilings", {json_}}};
        std::vector<TilingResult> tilings;
        JsonMembers(StoredObject(root, folder_.path() / "results.json")).objects("tilings", tilings);
        return tilings;
    }

    std::string error() const
    {
        return refusal_of([&] {
            const auto tilings = read();
            read_tiles(folder_.path(), tilings.at(0));
        });
    }

    TemporaryFolder folder_;
    json json_ = json::parse(R"({"name": "n", "label": "L", "kind": "corner", "colors": 3, "tiles": 81,
        "file": "tiles.txt", "algorithm": "direct", "window": [-1, 2, 3, 2], "hash": "xxh64", "hash_period": [0, 0],
        "period": [0, 0, 0], "statistics": {"size": 1024, "samples": 262144,
            "tile_frequencies": {"chi_square": 70.5, "p_value": 0.5},
            "colors": [{"name": "corners", "counts": [1, 2, 3], "frequencies": {"chi_square": 1.5, "p_value": 0.25},
                "autocorrelation": {"file": "a.exr", "lags": 320, "largest": 4.5, "largest_at": [3, 4],
                                    "bound": 5}}]}})");
};

TEST_F(TilingResults, AreRead)
{
    const auto tilings = read();
    ASSERT_EQ(tilings.size(), 1);
    const TilingResult& tiling = tilings[0];
    EXPECT_EQ(tiling.kind, TileKind::corner);
    EXPECT_EQ(tiling.colors, 3);
    EXPECT_EQ(tiling.shown(), 6);
    EXPECT_EQ(tiling.origin[0], -1);
    EXPECT_EQ(tiling.size[1], 2);
    ASSERT_TRUE(tiling.statistics);
    EXPECT_EQ(tiling.statistics->tiles->p_value, 0.5);
    ASSERT_EQ(tiling.statistics->colors.size(), 1);
    EXPECT_EQ(tiling.statistics->colors[0].counts.size(), 3);
    EXPECT_EQ(tiling.statistics->colors[0].autocorrelation.largest_at[1], 4);
    EXPECT_THAT(read_tiles(folder_.path(), tiling), ElementsAre(1, 80, 3, 4, 5, 6));
}

TEST_F(TilingResults, SetsHaveAllTheirTiles)
{
    json_ = json::parse(
        R"({"name": "n", "label": "L", "kind": "wang", "colors": 2, "tiles": 3, "file": "tiles.txt",
                            "set": "compact"})");
    folder_.write("tiles.txt", "0 5 15\n");
    EXPECT_THAT(read_tiles(folder_.path(), read().at(0)), ElementsAre(0, 5, 15));
}

TEST_F(TilingResults, DamagedOnesNameTheMember)
{
    const json good = json_;
    const auto error_after = [&](auto damage) {
        json_ = good;
        damage(json_);
        return error();
    };
    EXPECT_THAT(error_after([](json& j) { j["name"] = "../n"; }), HasSubstr("tilings[0].name = \"../n\": "));
    EXPECT_THAT(error_after([](json& j) { j["kind"] = "hexagon"; }), HasSubstr("tilings[0].kind = \"hexagon\": "));
    EXPECT_THAT(error_after([](json& j) { j["colors"] = 257; }), HasSubstr("tilings[0].colors = 257: "));
    EXPECT_THAT(error_after([](json& j) { j["window"] = {0, 0, 3}; }), HasSubstr("tilings[0].window: "));
    EXPECT_THAT(error_after([](json& j) { j["window"] = {0, 0, 3, 1e18}; }), HasSubstr("tilings[0].window: "));
    EXPECT_THAT(error_after([](json& j) { j["window"] = {0, 0, 3, 3}; }), HasSubstr("must hold 9 tile indices"));
    EXPECT_THAT(error_after([](json& j) { j["colors"] = 2; }), HasSubstr("80 is no tile of 2 colours"));
    EXPECT_THAT(error_after([](json& j) { j["statistics"]["colors"][0]["autocorrelation"]["file"] = "b.exr"; }),
                HasSubstr("colors[0].autocorrelation.file = "));
    json_ = good;
    folder_.write("tiles.txt", "1 2 3 4 5 x\n");
    EXPECT_THAT(error(), HasSubstr("must hold 6 tile indices"));
}

}
}
