// Tests measure the recurrence of tiles of photographs, and of pictures whose law is known.
#include "host/distribution/textures/texture_values.hpp"
#include "host/texture/comparison/light_map.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/places.hpp"
#include "tests/tiles/texture/dead_leaves.hpp"
#include "tiles/texture/texture_tiling.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace poissonlab {
namespace {

double lattice_power_of(const PngPixels& picture, int stages)
{
    TextureRequest request;
    request.colors = {3, 3};
    request.stages = stages;
    const auto go_on = [](const std::string&, std::size_t, std::size_t) {};
    const TextureSet set = build_texture(request, picture, go_on).set;
    return lattice_power(
        texture_window_pixels(set, texture_window(set, {0, 0, 16, 16}, 1), set.values, picture.channels), set.size,
        set.size);
}

/// With three colours, whatever all tiles have from the patches of corners has a third of its power at 1/T, what they
/// have from edges a ninth. One stage leaves more than a third of a tile to patches, three stages what is near corners,
/// and they choose plain patches there.
TEST(CornerRepetition, IsLessThanHalfOfThatOfOneStage)
{
    for (const std::string name : {"gravel", "cork", "grass"}) {
        const PngPixels picture = read_exemplar(source_folder() + "/configs/exemplars/" + name + ".png");
        const double three = lattice_power_of(picture, 3), one = lattice_power_of(picture, 1);
        EXPECT_LT(three, one / 2) << name << " " << one;
        EXPECT_LT(three, 0.105) << name; // of chance 1 / 256; the exemplars themselves have 0.018, with chance 1 / 64
    }
}

TextureSet fitted_set(const PngPixels& exemplar, TextureKind kind, std::uint64_t seed)
{
    TextureRequest request;
    request.kind = kind;
    request.tiles = kind == TextureKind::omega ? "16" : "complete";
    request.colors = kind == TextureKind::omega ? WangColors{4, 4} : WangColors{2, 2};
    request.size = 16;
    request.attempts = request.candidates = 2;
    request.seed = seed;
    return build_texture(request, exemplar, [](const std::string&, std::size_t, std::size_t) {}).set;
}

/// The picture of a tiling says the same as how often each tile is in it.
TEST(Recurrence, OfASetIsThatOfItsPicture)
{
    const PngPixels exemplar = test::dead_leaves(96, 96, 3, 1);
    for (const TextureKind kind : {TextureKind::corner, TextureKind::wang, TextureKind::omega}) {
        const TextureSet set = fitted_set(exemplar, kind, 1);
        const int period = recurrence_period(set) * set.size;
        EXPECT_EQ(period, kind == TextureKind::omega ? 32 : 16);
        const PngPixels picture = texture_window_pixels(
            set, texture_window(set, {0, 0, recurrence_tiles, recurrence_tiles}, 7), set.values, 3);
        EXPECT_NEAR(*set_recurrence(set, 7), *recurrence(picture, period, period), 1e-9) << texture_kinds[kind];
    }
}

/// A quarter of an exemplar has fewer windows, and what tiles have in common does not become less: over pairs of sets
/// the mean difference is not below 0 by three of its standard errors. The exemplar's own share of chance is four times
/// as large, so that what is divided by it would fall.
TEST(Recurrence, IsNotLoweredByCroppingTheExemplar)
{
    constexpr unsigned pairs = 16;
    double sum = 0, squares = 0, divided = 0, divided_of_quarter = 0;
    for (unsigned seed = 1; seed <= pairs; ++seed) {
        const PngPixels whole = test::dead_leaves(128, 128, 1, seed, 2000),
                        quarter = picture_part(whole, 32, 32, 64, 64);
        const double of_whole = *set_recurrence(fitted_set(whole, TextureKind::corner, seed), seed),
                     of_quarter = *set_recurrence(fitted_set(quarter, TextureKind::corner, seed), seed);
        sum += of_quarter - of_whole;
        squares += (of_quarter - of_whole) * (of_quarter - of_whole);
        divided += of_whole / lattice_power(whole, 16, 16) / pairs;
        divided_of_quarter += of_quarter / lattice_power(quarter, 16, 16) / pairs;
    }
    const double mean = sum / pairs, error = std::sqrt((squares / pairs - mean * mean) / (pairs - 1));
    EXPECT_GT(mean, -3 * error) << mean << " " << error;
    EXPECT_LT(divided_of_quarter, divided / 2);
}

/// Stripes, and noise upon them; tiles are windows of one phase, each with its own noise. What all tiles have in common
/// by the stripes does not count, and 16 tiles of noise have a sixteenth in common, within the standard error of 256
/// sums of squares.
TEST(Recurrence, OfRegularPicturesIsWhatTheyHaveBesideTheirPhases)
{
    const PngPixels noise = test::random_picture(256, 256, 1, 3, 64);
    TextureSet set;
    set.colors = {2, 2};
    set.size = 16;
    set.exemplar = noise;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
            set.exemplar.values[noise.at(x, y, 0)] =
                static_cast<std::uint8_t>(noise.values[noise.at(x, y, 0)] + (y % 8 < 3 ? 120 : 0));
    std::mt19937 random(1);
    for (TileIndex tile = 0; tile < 16; ++tile) {
        set.tiles.push_back({tile, 0});
        const auto left = static_cast<int>(random() % 240), top = static_cast<int>(random() % 30) * 8;
        for (int y = top; y < top + 16; ++y)
            for (int x = left; x < left + 16; ++x) {
                set.sources.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
                set.values.push_back(set.exemplar.values[set.exemplar.at(x, y, 0)]);
            }
    }
    EXPECT_NEAR(*set_recurrence(set, 1), 1.0 / 16, 5 * std::sqrt(2.0 / 256) / 16);
    const PngPixels picture =
        texture_window_pixels(set, texture_window(set, {0, 0, recurrence_tiles, recurrence_tiles}, 1), set.values, 1);
    EXPECT_GT(*recurrence(picture, 16, 16), 0.9);
}

}
}
