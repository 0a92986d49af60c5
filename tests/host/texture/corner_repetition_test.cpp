// What corner tiles repeat on photographs.
#include "host/texture/exemplar.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/support/places.hpp"
#include "tiles/texture/texture_tiling.hpp"
#include "tiles/texture/tiling_measures.hpp"

#include <gtest/gtest.h>

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
        texture_window_pixels(set, texture_window(set, {0, 0, 16, 16}, 1), set.values, picture.channels), set.size);
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

}
}
