// runtime/poisson_tiles_gpu.h as GLSL ES 3.00, in the WebGL2 of a browser, against runtime/poisson_tiles.js, which is
// the C header to the last bit. Needs Chromium.
#include "base/files/whole_file.hpp"
#include "tests/support/browser.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

/// A page with the runtime as a script, the header and a tile set's bytes, and what tests call.
std::string webgl_page(const std::string& tile_set)
{
    const std::string runtime = source_folder() + "/runtime/";
    nlohmann::json bytes = nlohmann::json::array();
    for (const char byte : read_whole_file(runtime + "tile_sets/" + tile_set))
        bytes.push_back(static_cast<unsigned char>(byte));
    return "<!doctype html><meta charset='utf-8'><script>" + read_whole_file(runtime + "poisson_tiles.js") +
           "</script><script>const header = " +
           nlohmann::json(read_whole_file(runtime + "poisson_tiles_gpu.h")).dump() +
           "; const bytes = Uint8Array.from(" + bytes.dump() + ");</script><script>" +
           read_whole_file(source_folder() + "/tests/runtime/expected_words.js") + "</script><script>" +
           read_whole_file(source_folder() + "/tests/runtime/glsl_es_test.js") + "</script>";
}

class GlslEs : public testing::TestWithParam<const char*>
{
};

TEST_P(GlslEs, HasThePointsOfAMillionPlaces)
{
    const TemporaryFolder folder;
    write_whole_file(folder.path() / "page.html", webgl_page(GetParam()));
    test::Browser browser;
    browser.set_limit(std::chrono::minutes(3));
    browser.open(folder.path() / "page.html");
    if (!browser.evaluate("document.createElement('canvas').getContext('webgl2') !== null").get<bool>())
        GTEST_SKIP() << "no WebGL2";
    EXPECT_EQ(browser.evaluate("differences(0, 0)"), (nlohmann::json{1'048'576, 0}));
    EXPECT_EQ(browser.evaluate("differences(7, 1000)"), (nlohmann::json{1'048'576, 0}));
    // Nearest points by floats are those by doubles, but for points that are as near to a float's last bits.
    const nlohmann::json nearest = browser.evaluate("nearestDifferences()");
    EXPECT_EQ(nearest[0], 16'384);
    EXPECT_LE(nearest[1].get<int>(), 3);
    EXPECT_LT(nearest[2].get<double>(), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(In, GlslEs, testing::Values("corner-c4-n64-r075.ptiles", "sphere-c2-n128-r075.ptiles"),
                         [](const auto& set) { return std::string(set.index == 0 ? "plane" : "space"); });

}
}
