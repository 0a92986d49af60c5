// Tables [[texture]] and [[packing]]: what they make, measured on sets whose seams cannot be told.
#include "host/device/device.hpp"
#include "host/distribution/textures/texture_run.hpp"
#include "results/texture_measures.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/packing/tile_packing.hpp"
#include "tiles/texture/texture_certificate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace poissonlab {
namespace {

using testing::Contains;

class TextureRun : public testing::Test
{
protected:
    DistributionResult make(const auto& settings, Engine engine = Engine::reference)
    {
        std::optional<Device> device;
        DistributionPlace place;
        place.engine = engine;
        place.device = [&]() -> Device& { return device ? *device : device.emplace(Device::open()); };
        return made_of(settings, 1, folder_.path(), place);
    }

    static TextureSettings noise_settings()
    {
        TextureSettings settings;
        settings.pattern = "noise";
        settings.pattern_size = 160;
        settings.request.colors = {2, 2};
        settings.request.size = 32;
        settings.request.attempts = 4;
        settings.request.candidates = 1;
        return settings;
    }

    /// The words for the key `show` of a table, from its description.
    static std::vector<std::string> shows_of(const std::string& table)
    {
        for (const KeySpec& spec : find_kind(table, "")->keys()) {
            if (spec.value.key != "show") continue;
            if (spec.own.empty()) return spec.value.choices;
            std::vector<std::string> words;
            std::string list = spec.own.substr(std::string("a list of ").size());
            std::ranges::replace(list, ',', ' ');
            std::istringstream text(list);
            for (std::string word; text >> word;) words.push_back(word);
            return words;
        }
        return {};
    }

    static double number(const DistributionResult& result, const std::string& key)
    {
        for (const DistributionNumber& one : result.numbers)
            if (one.key == key) return one.value;
        ADD_FAILURE() << key;
        return 0;
    }

    TemporaryFolder folder_;
};

TEST_F(TextureRun, MakesEveryPictureAndASetThatIsProven)
{
    TextureSettings settings = noise_settings();
    settings.show = shows_of("texture");
    settings.is_compared = true;
    settings.pattern_size = 176; // large patches fit
    const DistributionResult result = make(settings);
    for (const DistributionPicture& picture : result.pictures)
        EXPECT_TRUE(std::filesystem::exists(folder_.path() / picture.file)) << picture.file;
    EXPECT_EQ(result.pictures.size(), shows_of("texture").size() - 3); // no marks, nothing Gaussian
    EXPECT_EQ(certify_texture(read_texture_set(folder_.path())).exceptions, 0u);
    EXPECT_EQ(result.numbers.size(), texture_measures().size() - 3) << "all but what is timed on a device";
    const PngPixels seams = read_png(folder_.path() / "seams.png");
    EXPECT_EQ(seams.width, 2 * 4 * 32);
}

/// Textures without tiles have measures of pictures, memory, look-ups, colours and repetition; quilted pictures have
/// those of seams as well.
TEST_F(TextureRun, MakesEndlessTexturesWithoutTiles)
{
    for (const auto& [method, word] : endless_methods.entries) {
        TextureSettings settings = noise_settings();
        settings.request.size = 16;
        settings.endless.emplace().method = method;
        settings.endless->block = 24;
        settings.is_compared = method == EndlessMethod::quilted;
        settings.show = method == EndlessMethod::blended ? std::vector<std::string>{"tiling", "gaussian"}
                                                         : std::vector<std::string>{"tiling", "exemplar"};
        const DistributionResult result = make(settings);
        EXPECT_EQ(result.parameter("kind"), word);
        ASSERT_EQ(result.pictures.size(), 2u);
        const PngPixels window = read_png(folder_.path() / result.pictures[0].file);
        EXPECT_EQ(window.width, 8 * 16);
        EXPECT_EQ(window.height, 4 * 16);
        const std::map<EndlessMethod, int> fetches{{EndlessMethod::repeated, 1},
                                                   {EndlessMethod::offsets, 4},
                                                   {EndlessMethod::hexagons, 3},
                                                   {EndlessMethod::blended, 4},
                                                   {EndlessMethod::quilted, 1}};
        EXPECT_EQ(number(result, "fetches"), fetches.at(method)) << word;
        // Squares of noise of 300 pixels and more: by chance alone a share of at most 1/100 would be off by a tenth.
        EXPECT_NEAR(number(result, "recurrence"), method == EndlessMethod::repeated ? 1 : 0, 0.01) << word;
        if (method != EndlessMethod::quilted) continue;
        EXPECT_GT(number(result, "seam_mismatch"), 0);
        EXPECT_NEAR(number(result, "peak_times"), 1, 0.5);
    }
}

/// Plain repetition repeats, also where the square that is measured holds one exemplar only.
TEST_F(TextureRun, CallsLargeRepeatedExemplarsRepeated)
{
    TextureSettings settings = noise_settings();
    settings.pattern_size = 2100;
    settings.endless.emplace().method = EndlessMethod::repeated;
    settings.show = {"exemplar"};
    EXPECT_EQ(number(make(settings), "recurrence"), 1);
}

/// Times are said to be such, and pictures are the same on a device.
TEST_F(TextureRun, TimesEndlessTextures)
{
    TextureSettings settings = noise_settings();
    settings.endless.emplace().method = EndlessMethod::repeated;
    settings.show = {"tiling"};
    make(settings);
    const PngPixels plain = read_png(folder_.path() / "tiling.png");
    settings.has_timing = true;
    const DistributionResult result = make(settings, Engine::opencl);
    EXPECT_EQ(read_png(folder_.path() / "tiling.png").values, plain.values);
    for (const DistributionNumber& one : result.numbers)
        EXPECT_EQ(one.is_time, one.key == "pixel_nanoseconds" || one.key == "plain_frames" || one.key == "frames")
            << one.key;
    EXPECT_GT(number(result, "frames"), 0);
    EXPECT_NEAR(number(result, "pixel_nanoseconds") * number(result, "plain_frames"), 1e9 / (1920.0 * 1080), 1);
}

/// Marks are shown, and laid by a picture.
TEST_F(TextureRun, MakesMarkedTiles)
{
    TextureSettings settings = noise_settings();
    for (const unsigned seed : {1u, 2u}) {
        const PngPixels picture = test::random_picture(80, 80, 1, seed);
        write_png(folder_.path() / (seed == 1 ? "plain.png" : "marked.png"), {80, 80, 1},
                  [&](int row, int) { return &picture.values[picture.at(0, row, 0)]; });
    }
    settings.pattern.clear();
    settings.exemplar = folder_.path() / "plain.png";
    settings.marked_exemplar = settings.marks = folder_.path() / "marked.png";
    settings.request.kind = TextureKind::wang;
    settings.request.tiles = "compact";
    settings.request.split = 1;
    settings.request.weight = SeamWeight::gradient; // plain cuts between both pictures also run along borders
    settings.show = {"marks", "tiling-marks"};
    const DistributionResult result = make(settings);
    EXPECT_EQ(number(result, "tiles"), 128);
    EXPECT_EQ(result.parameter("marked_exemplar"), "marked");
    // Four rows of four tiles, 16 pixels apart, twice as large.
    const PngPixels marks = read_png(folder_.path() / "marks.png");
    EXPECT_EQ(marks.width, 2 * (4 * (32 + 16) + 16));
    EXPECT_EQ(marks.height, marks.width);
    EXPECT_EQ(read_png(folder_.path() / "tiling-marks.png").width, 8 * 32);
    EXPECT_EQ(certify_texture(read_texture_set(folder_.path())).joints, 0u);
}

/// On white noise no seam can be told: steps over seams are as conspicuous as those of the exemplar.
TEST_F(TextureRun, FindsNoSeamsInNoise)
{
    TextureSettings settings = noise_settings();
    settings.show = {"exemplar"};
    settings.sets = 13;
    // Chosen windows and cuts make seams smaller than chance, never larger.
    const DistributionResult result = make(settings);
    EXPECT_LT(number(result, "conspicuous_seams"), 0.05);
    EXPECT_LT(number(result, "seam_mismatch"), 1.05);
    // Four edges in both directions with 32 steps each, in so many sets: differences of evenly distributed numbers have
    // a relative standard deviation of sqrt(1/18) / (1/3), so that this is four standard errors.
    EXPECT_NEAR(number(result, "border_step"), 1, 4 * std::sqrt(0.5 / (13 * 2 * 4 * 32)));
    EXPECT_EQ(number(result, "sets"), 13);
    EXPECT_TRUE(result.numbers[3].standard_error);
}

/// Repetition of two Wang colours is that of few samples; one tile again and again has all of its power on the lattice.
TEST_F(TextureRun, TellsRepetition)
{
    TextureSettings few = noise_settings(), many = noise_settings();
    few.show = many.show = {"exemplar"};
    few.request.stages = 0;
    many.request.colors = {3, 3};
    EXPECT_GT(number(make(few), "lattice_power"), 2 * number(make(many), "lattice_power"));
}

/// A frame takes no less than to write each of its pixels at a terabyte a second, which no device hands over, and no
/// more than a minute.
TEST_F(TextureRun, TimesFramesWhereItIsAskedTo)
{
    TextureSettings settings = noise_settings();
    settings.show = {"exemplar"};
    settings.sets = 2;
    settings.has_timing = true;
    const double frames = number(make(settings, Engine::opencl), "frames");
    EXPECT_GT(frames, 1.0 / 60);
    EXPECT_LT(frames, 1e12 / (1024 * 576 * 3 * 4));
}

TEST_F(TextureRun, DrawsPackingsWithTheirNumbers)
{
    for (const std::string& show : shows_of("packing")) {
        PackingSettings settings;
        settings.method = "closed";
        settings.show = show;
        const DistributionResult result = make(settings);
        EXPECT_EQ(result.pictures.size(), 1u);
        EXPECT_FALSE(read_mark_picture(folder_.path() / result.pictures[0].file).groups.empty());
    }
    EXPECT_FALSE(packing_fault(read_packing(folder_.path() / "tiles.txt", TileKind::corner, 2)));
}

/// D. section 5.4: corner tiles need half of the memory. All edges along a column of a product packing have one colour,
/// and all along a row, so that C^2 of the C^4 corners of Wang tiles are in it; a second packing has them all.
TEST_F(TextureRun, CountsTheCornersThatPackingsLack)
{
    for (Color c = 2; c <= 5; ++c) {
        PackingSettings settings;
        settings.colors = c;
        EXPECT_EQ(number(make(settings), "stored_squares"), c * c * c * c);
        settings.kind = TileKind::wang;
        const DistributionResult wang = make(settings);
        EXPECT_EQ(number(wang, "stored_squares"), 2 * c * c * c * c);
        EXPECT_EQ(number(wang, "corners_in_packing"), c * c);
        settings.show = "corners";
        EXPECT_EQ(number(make(settings), "corners_in_packing"), c * c * c * c);
    }
    PackingSettings searched;
    searched.kind = TileKind::wang, searched.method = "search";
    const double corners = number(make(searched), "corners_in_packing");
    EXPECT_GE(corners, 4);
    EXPECT_LE(corners, 16);
}

}
}
