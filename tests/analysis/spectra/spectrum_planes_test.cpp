#include "analysis/spectra/spectrum_file.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace poissonlab {
namespace {

std::vector<std::string> names_of(int size)
{
    std::vector<std::string> names;
    for (const PlanePlace& place : shown_planes(size)) names.push_back(plane_name(place));
    return names;
}

TEST(SpectrumPlanes, HaveNames)
{
    EXPECT_THAT(names_of(256),
                testing::ElementsAre("xy", "xz", "yz", "xy_-128", "xz_-128", "yz_-128", "xy_16", "xy_32", "xy_48"));
}

TEST(SpectrumPlanes, AreThereOnceInSmallSpectra)
{
    EXPECT_THAT(names_of(2), testing::ElementsAre("xy", "xz", "yz", "xy_-1", "xz_-1", "yz_-1"));
    EXPECT_THAT(names_of(8), testing::ElementsAre("xy", "xz", "yz", "xy_-4", "xz_-4", "yz_-4", "xy_1"));
}

TEST(SpectrumPlanes, CutAVolume)
{
    constexpr int size = 6;
    Spectrum volume{3, size, 7, 2, {}};
    for (int w = -3; w < 3; ++w)
        for (int v = -3; v < 3; ++v)
            for (int u = -3; u < 3; ++u) {
                volume.power.push_back(100 * u + 10 * v + w);
                volume.variance.push_back(u);
            }
    for (const int k : {-3, 0, 2}) {
        EXPECT_EQ(spectrum_plane(volume, {0, k}).at(-2, 1), 100 * k + 10 * -2 + 1); // (v, w)
        EXPECT_EQ(spectrum_plane(volume, {1, k}).at(-2, 1), 100 * -2 + 10 * k + 1); // (u, w)
        EXPECT_EQ(spectrum_plane(volume, {2, k}).at(-2, 1), 100 * -2 + 10 + k);     // (u, v)
    }
    const Spectrum plane = spectrum_plane(volume, {1, 0});
    EXPECT_EQ(plane.dimension, 2);
    EXPECT_EQ(plane.points, 7u);
    EXPECT_EQ(plane.realizations, 2);
    ASSERT_EQ(plane.variance.size(), 36u);
    EXPECT_EQ(plane.variance[5], 2) << "column u = 2";
    EXPECT_THROW(spectrum_plane(volume, {3, 0}), std::invalid_argument);
    EXPECT_THROW(spectrum_plane(volume, {0, 3}), std::invalid_argument);
    EXPECT_THROW(spectrum_plane(plane, {0, 0}), std::invalid_argument);
}

}
}
