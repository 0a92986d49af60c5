// runtime/poisson_tiles_gpu.h, as OpenCL C, against runtime/poisson_tiles.h.
#include "host/device/device.hpp"
#include "host/device/kernel_source.hpp"
#include "tests/runtime/tile_set_cases.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

/// One work-item looks at one place: a tile's number, all of its coordinates, the nearest point to a position
/// in it.
constexpr auto kernels = R"(
    kernel void query(global const uint* words, uint kind, uint dimension, uint colors, uint tiles, uint points_per_tile,
                      uint seed, int period, int low, int step, int below, int above, uint ranks, global const int* places, global const float* positions, uint count,
                      global uint* results, global float* distances, global float* coordinates, global float* levels)
    {
        const uint id = get_global_id(0);
        if (id >= count) return;
        const struct ptiles_tiling t = {kind, dimension, colors, tiles, points_per_tile, seed, period, low, step, below, above, ranks};
        const int3 home = vload3(id, places);
        const struct ptiles_nearest nearest = ptiles_nearest_point(words, t, home, vload3(id, positions));
        global uint* result = results + 6 * id;
        result[0] = ptiles_tile(t, home);
        result[1] = nearest.tile.x;
        result[2] = nearest.tile.y;
        result[3] = nearest.tile.z;
        result[4] = nearest.index;
        result[5] = nearest.id;
        distances[id] = nearest.distance;
        levels[id] = ptiles_level(words, t, ptiles_tile(t, nearest.tile), nearest.index, nearest.id);
        vstore3(ptiles_point(words, t, result[0], id % points_per_tile), id, coordinates);
    }
)";

constexpr std::uint32_t count = 3000;

struct Queries
{
    std::vector<std::int32_t> places;
    std::vector<float> positions;
};

/// Makes queries near the origin and anywhere. Positions are multiples of the unit, so that differences are exact.
Queries make_queries(int dimension)
{
    std::mt19937 random(1);
    Queries queries;
    for (std::uint32_t i = 0; i < 3 * count; ++i) {
        const auto anywhere = static_cast<std::int32_t>(random()) / 2;
        const bool flat = dimension == 2 && i % 3 == 2;
        queries.places.push_back(flat ? 0 : i % 2 == 0 ? anywhere : anywhere % 10);
        queries.positions.push_back(flat ? 0 : static_cast<float>(random() % 65536) / 65536);
    }
    return queries;
}

class GpuHeader : public testing::Test
{
protected:
    template <class T>
    Buffer<T> copied(const std::vector<T>& values)
    {
        Buffer<T> buffer = device_.buffer<T>(values.size());
        buffer.write(values);
        return buffer;
    }

    void expect_same(const PoissonTileSet& set, const PoissonTiling& choice);

    Device device_ = Device::open();
};

void GpuHeader::expect_same(const PoissonTileSet& set, const PoissonTiling& choice)
{
    const ptiles_tiling tiling = runtime_tiling(set, choice);
    const ptiles_set& s = tiling.set;
    const Queries queries = make_queries(set.parameters.dimension);
    std::vector<std::uint16_t> words = set.points;
    words.insert(words.end(), set.chain_lengths.begin(), set.chain_lengths.end());
    const auto first_rank = static_cast<std::uint32_t>(set.ranks.empty() ? 0 : words.size());
    words.insert(words.end(), set.ranks.begin(), set.ranks.end());
    words.resize((words.size() + 1) / 2 * 2);
    auto results = device_.buffer<std::uint32_t>(6 * count);
    auto distances = device_.buffer<float>(count);
    auto coordinates = device_.buffer<float>(3 * count);
    auto levels = device_.buffer<float>(count);
    device_.kernel_from_text(kernel_source("runtime/poisson_tiles_gpu.h") + kernels, "gpu_header_test.cl", "query")
        .run(count, 64, copied(words), s.kind, s.dimension, s.colors, s.tiles, s.points_per_tile, tiling.seed,
             tiling.period, s.low, s.step, s.below, s.above, first_rank, copied(queries.places),
             copied(queries.positions), count, results, distances, coordinates, levels);
    const auto found = results.read(0, results.size());
    const auto squared_of = distances.read(0, count);
    const auto points = coordinates.read(0, coordinates.size());
    const auto level_of = levels.read(0, count);

    std::size_t ties = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t* const place = &queries.places[3 * i];
        ASSERT_EQ(found[6 * i], ptiles_tile(&tiling, place[0], place[1], place[2])) << name_of(set) << " " << i;
        const std::uint16_t* units = ptiles_points(&s, found[6 * i]) + i % s.points_per_tile * s.dimension;
        double position[3];
        for (std::size_t axis = 0; axis < s.dimension; ++axis) {
            ASSERT_EQ(points[3 * i + axis], static_cast<float>(ptiles_coordinate(&s, units[axis])));
            position[axis] = place[axis] + static_cast<double>(queries.positions[3 * i + axis]);
        }
        ptiles_point nearest;
        const double distance = std::sqrt(ptiles_nearest(&tiling, position, &nearest));
        ASSERT_NEAR(squared_of[i], distance, 1e-6);
        const std::uint32_t* const f = &found[6 * i];
        const bool same =
            std::equal(nearest.tile, nearest.tile + 3, f + 1,
                       [](std::int32_t a, std::uint32_t b) { return static_cast<std::uint32_t>(a) == b; }) &&
            nearest.index == f[4];
        ASSERT_TRUE(!same || nearest.id == f[5]);
        ASSERT_TRUE(!same || std::abs(level_of[i] - nearest.level) < 1e-7);
        ties += !same; // equal distances as floats
    }
    EXPECT_LE(ties, count / 500);
}

TEST_F(GpuHeader, FindsWhatTheHeaderForEnginesFinds)
{
    for (const PoissonTileSet& set : tile_sets_of_every_kind())
        for (const PoissonTiling& tiling : {PoissonTiling{1, 0}, PoissonTiling{0x89abcdef, 6}, PoissonTiling{3, 1}})
            expect_same(set, tiling);
}

}
}
