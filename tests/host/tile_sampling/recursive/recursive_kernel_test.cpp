// Recursive Wang tiles on a device: the points of the plain twin, in its order.
#include "host/tile_sampling/recursive/recursive_sampler.hpp"

#include "base/densities/density_text.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// A density on a torus of so many tiles along each axis.
struct RecursiveCase
{
    std::uint32_t side;
    std::uint64_t points;
    std::string density; ///< a formula; empty: the same everywhere
    std::size_t group_size = 0;
};

class RecursiveKernels : public testing::TestWithParam<RecursiveCase>
{
};

TEST_P(RecursiveKernels, FindThePointsOfTheTwin)
{
    static const RecursiveTileSet tiles = build_recursive_tiles(128, 1);
    const auto& [side, points, formula, group_size] = GetParam();
    std::optional<Density> pixels;
    if (!formula.empty()) pixels = density_of_formula(formula, 1, 1);
    const RecursiveDensity density(points, side, 0, pixels);
    RecursiveGenerator generator(Device::open(), tiles, density, group_size);
    for (std::uint32_t realization = 0; realization < 2; ++realization) {
        const RecursiveTiling tiling(tiles, side, stream_key(1, Purpose::recursive_tilings, realization));
        for (const RecursiveDrawing drawing : {RecursiveDrawing::once, RecursiveDrawing::twice})
            EXPECT_EQ(generator.torus_points(tiling, drawing), tiling.torus_points(density, drawing));
    }
}

INSTANTIATE_TEST_SUITE_P(Small, RecursiveKernels,
                         testing::Values(RecursiveCase{1, 40, "", 8}, RecursiveCase{2, 200, "x + y + 3", 8}));

/// Few points, several levels, more ranks than a call takes, and a peak so high that tiles are divided again and again.
INSTANTIATE_TEST_SUITE_P(Densities, RecursiveKernels,
                         testing::Values(RecursiveCase{1, 1, ""}, RecursiveCase{3, 18'437, ""},
                                         RecursiveCase{5, 2'000'003, ""}, RecursiveCase{4, 50'000, "1 + x*y"},
                                         RecursiveCase{2, 3'000, "x > 0.97 ? (y > 0.97 ? 1 : 0) : 0"}));

}
}
