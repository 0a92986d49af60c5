// Every page of the reports of the configs that ship, in a browser: quiet, no wider than the window, and without
// pictures that show nothing. Needs Chromium.
#include "tests/support/browser.hpp"
#include "tests/support/picture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"
#include "tests/support/small_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// Configs of many pages of the kinds that those of other configs are of.
const std::set<std::string> large_configs{"baselines",        "early-tiles",     "gallery-2d", "gallery-2d-optimized",
                                          "gallery-2d-tiles", "gallery-3d",      "glass",      "integration",
                                          "poisson-tiles",    "ranks",           "seamless",   "textures",
                                          "textures_peers",   "tile-relaxation", "today"};

/// One that is not there would be looked at by nobody.
TEST(LargeConfigs, AreThere)
{
    for (const std::string& name : large_configs)
        EXPECT_TRUE(fs::exists(source_folder() + "/configs/" + name + ".toml")) << name;
}

/// The configs in the folder itself, but for collections, whose configs are figures of one kind each.
std::vector<std::string> shipped_config_names(bool are_large)
{
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(source_folder() + "/configs")) {
        const std::string name = entry.path().stem();
        if (entry.path().extension() == ".toml" && name != "dissertation" && large_configs.contains(name) == are_large)
            names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

/// The elements that reach beyond the right edge of the page, but for those in a box that scrolls.
constexpr auto too_wide = R"((() => {
    const scrolls = e => ['auto', 'scroll'].includes(getComputedStyle(e).overflowX);
    const is_held = e => e !== document.body && (scrolls(e) || is_held(e.parentElement));
    return Array.from(document.body.querySelectorAll('*'))
        .filter(e => e.getBoundingClientRect().width > 0)
        .filter(e => e.getBoundingClientRect().right > document.documentElement.clientWidth + 1)
        .filter(e => !is_held(e.parentElement))
        .map(e => e.outerHTML.slice(0, 160));
})())";

/// Tables that scroll sideways and whose first column does not stay, or leaves no room for others.
constexpr auto without_heads = R"((() => Array.from(document.querySelectorAll('.frame'))
    .filter(f => f.scrollWidth > f.clientWidth)
    .filter(f => Array.from(f.querySelectorAll('tr')).some(row => row.cells[0].colSpan === 1 && (
        getComputedStyle(row.cells[0]).position !== 'sticky' || row.cells[0].offsetWidth > 0.7 * f.clientWidth)))
    .map(f => f.outerHTML.slice(0, 160)))())";

/// The part of the pixels of an SVG document, drawn on white, that have its most frequent colour.
std::string plain_part_script(const std::string& svg)
{
    return "new Promise(done => { const image = new Image(); image.onerror = () => done(1); image.onload = () => {"
           "const canvas = document.createElement('canvas'), side = 256; canvas.width = canvas.height = side;"
           "const pen = canvas.getContext('2d'); pen.fillStyle = '#fff'; pen.fillRect(0, 0, side, side);"
           "pen.drawImage(image, 0, 0, side, side); const counts = new Map();"
           "for (const v of new Uint32Array(pen.getImageData(0, 0, side, side).data.buffer))"
           "  counts.set(v, (counts.get(v) || 0) + 1);"
           "done(Math.max(...counts.values()) / (side * side)); };"
           "image.src = 'data:image/svg+xml,' + encodeURIComponent(" +
           nlohmann::json(svg).dump() + "); })";
}

double plain_part(const test::Picture& picture)
{
    std::array<std::size_t, 256> counts{};
    for (const std::uint8_t grey : picture.grey) ++counts[grey];
    return static_cast<double>(std::ranges::max(counts)) / static_cast<double>(picture.grey.size());
}

class ShippedReports : public testing::TestWithParam<std::string>
{
protected:
    /// Tile sets are those of this build, and of none that the user has.
    static void SetUpTestSuite()
    {
        ::setenv("POISSONLAB_CACHE", (fs::path(program_file()).parent_path() / "tests/tile-sets").c_str(), 1);
        browser_ = std::make_unique<test::Browser>(std::chrono::minutes(5));
    }
    static void TearDownTestSuite()
    {
        browser_.reset();
        ::unsetenv("POISSONLAB_CACHE");
    }

    /// Makes the report of a config at small sizes.
    void make_report(const std::string& name)
    {
        const fs::path configs = source_folder() + "/configs";
        folder_.write(name + ".toml", test::small_config(content_of(configs / (name + ".toml"))));
        for (const char* beside : {"alphabets", "exemplars", "regions", "surfaces", "your-method.awk"})
            fs::create_symlink(configs / beside, folder_.path() / beside);
        const Outcome outcome = run_program(folder_.path(), {"run", name + ".toml", "--out", "report", "--quiet"});
        ASSERT_EQ(outcome.status, 0) << outcome.error;
    }

    std::vector<fs::path> pages() const
    {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "report"))
            if (entry.path().extension() == ".html") found.push_back(entry.path());
        std::ranges::sort(found);
        return found;
    }

    /// Opens a page, on a desk and on a telephone, and adds its pictures to `pictures`.
    static void check_page(const fs::path& page, std::set<std::string>& pictures)
    {
        browser_->resize(1280, 900);
        browser_->open(page);
        for (const int width : {1280, 400}) {
            browser_->resize(width, 900, width < 600);
            EXPECT_THAT(browser_->evaluate(too_wide), IsEmpty()) << page << ", " << width;
            EXPECT_THAT(browser_->evaluate(without_heads), IsEmpty()) << page << ", " << width;
        }
        EXPECT_THAT(browser_->messages(), IsEmpty()) << page;
        EXPECT_THAT(browser_->requests(), IsEmpty()) << page;
        for (const std::string source : browser_->evaluate("Array.from(document.images, i => i.getAttribute('src'))"))
            if (!source.starts_with("data:")) pictures.insert((page.parent_path() / source).lexically_normal());
    }

    static void check_picture(const fs::path& file)
    {
        const std::string bytes = content_of(file);
        const bool is_png = file.extension() == ".png";
        const double plain =
            is_png ? plain_part(test::decode_png(bytes)) : browser_->evaluate(plain_part_script(bytes)).get<double>();
        EXPECT_LT(plain, 0.9999) << file << " is blank";
        // Plots have curves, not axes alone.
        if (bytes.find("gnuplot_canvas") != std::string::npos) {
            EXPECT_NE(bytes.find("id=\"gnuplot_plot_"), std::string::npos) << file << " has no curve";
        }
    }

    TemporaryFolder folder_;
    static inline std::unique_ptr<test::Browser> browser_;
};

TEST_P(ShippedReports, ShowWhatTheyHave)
{
    make_report(GetParam());
    if (HasFatalFailure()) return;
    std::set<std::string> pictures;
    for (const fs::path& page : pages()) check_page(page, pictures);
    EXPECT_FALSE(pictures.empty());
    for (const std::string& picture : pictures) check_picture(picture);
}

std::string words_of_config(const testing::TestParamInfo<std::string>& config)
{
    std::string name = config.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Configs, ShippedReports, testing::ValuesIn(shipped_config_names(false)), words_of_config);
INSTANTIATE_TEST_SUITE_P(Nightly, ShippedReports, testing::ValuesIn(shipped_config_names(true)), words_of_config);

}
}
