// kernels/common/tiles/tiling.clh against the host, at millions of places.
#include "host/device/device.hpp"
#include "host/device/kernel_source.hpp"
#include "tiles/tilings/cube_tiling.hpp"
#include "tiles/tilings/tiling.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

constexpr HashKind hashes[] = {HashKind::permutation, HashKind::long_period, HashKind::xxh64, HashKind::two_tables};

/// One work-item owns one place, three coordinates.
constexpr auto kernels = R"(
    #define PLACE \
        const uint id = get_global_id(0); \
        if (id >= count) return; \
        const long4 period = (long4)(px, py, pz, 0); \
        const long x = places[3 * id], y = places[3 * id + 1], z = places[3 * id + 2];
    #define PARAMETERS global const uint *h, global const uint *v, global const long *places, \
                       long px, long py, long pz, uint count, global uint *tiles
    kernel void look_up_corner(PARAMETERS) { PLACE tiles[id] = corner_tile_at(h, period, x, y); }
    kernel void look_up_sums(PARAMETERS) { PLACE tiles[id] = corner_sum_wang_tile_at(h, v, period, x, y); }
    kernel void look_up_edges(PARAMETERS) { PLACE tiles[id] = edge_hash_wang_tile_at(h, v, period, x, y); }
    kernel void look_up_cube(PARAMETERS) { PLACE tiles[id] = cube_at(h, period, x, y, z); }
    kernel void look_up_wang_cube(PARAMETERS) { PLACE tiles[id] = face_hash_wang_cube_at(h, period, x, y, z); }
    kernel void look_up_domino(PARAMETERS) { PLACE tiles[id] = domino_at(h, period, x); }
)";

/// Places near the origin, anywhere, and around both ends of the coordinates and of their halves.
std::vector<std::int64_t> make_places(std::size_t count)
{
    std::mt19937_64 random(1);
    constexpr std::int64_t centers[] = {0, INT64_MAX, std::int64_t{1} << 62, -(std::int64_t{1} << 62)};
    std::vector<std::int64_t> places;
    for (std::size_t i = 0; i < 3 * count; ++i) {
        const std::uint64_t bits = random();
        places.push_back(i % 2 == 0 ? static_cast<std::int64_t>(bits)
                                    : stepped(centers[bits % 4], (bits >> 2) % 1000 - 500));
    }
    return places;
}

class TilingKernel : public testing::Test
{
protected:
    TilingKernel() { places_buffer_.write(places_); }

    /// The tiles that a kernel gives at all places.
    std::vector<TileIndex> on_device(const std::string& kernel, const ColorHash& horizontal, const ColorHash& vertical,
                                     Period period)
    {
        const auto words = [&](const ColorHash& hash) {
            const auto values = std::visit([](const auto& h) { return h.device_words(); }, hash);
            auto buffer = device_.buffer<std::uint32_t>(values.size());
            buffer.write(values);
            return buffer;
        };
        auto tiles = device_.buffer<TileIndex>(count);
        device_
            .kernel_from_text(kernel_source("kernels/common/tiles/tiling.clh") + kernels, "tiling_kernel_test.cl",
                              kernel)
            .run(count, 64, words(horizontal), words(vertical), places_buffer_, period.x, period.y, period.z,
                 static_cast<std::uint32_t>(count), tiles);
        return tiles.read(0, count);
    }

    void expect_same(const std::string& kernel, const Tiling& tiling)
    {
        const auto tiles = on_device(kernel, tiling.hash(), tiling.vertical_hash(), tiling.period());
        for (std::size_t i = 0; i < count; ++i)
            ASSERT_EQ(tiles[i], tiling.tile(places_[3 * i], places_[3 * i + 1])) << kernel << " " << i;
    }

    static constexpr std::size_t count = 200'000;
    Device device_ = Device::open();
    std::vector<std::int64_t> places_ = make_places(count);
    Buffer<std::int64_t> places_buffer_ = device_.buffer<std::int64_t>(places_.size());
};

TEST_F(TilingKernel, GivesTheTilesOfTheHost)
{
    for (const HashKind hash : hashes) {
        for (const Color c : {2u, 7u}) {
            for (const Period period : {Period{}, Period{1000, 13, 0}, Period{0, 256, 0}}) {
                expect_same("look_up_corner", Tiling(DirectAlgorithm::corner, {c, c}, hash, 1, period));
                expect_same("look_up_sums", Tiling(DirectAlgorithm::wang_two_hashes, {c, 3}, hash, 1, period));
                expect_same("look_up_sums", Tiling(DirectAlgorithm::wang_one_hash, {c, c}, hash, 1, period));
                expect_same("look_up_edges", Tiling(DirectAlgorithm::wang_edge_hash, {c, c}, hash, 1, period));
                expect_same("look_up_edges", Tiling(DirectAlgorithm::wang_edge_hash, {3, c}, hash, 1, period));
            }
        }
    }
}

TEST_F(TilingKernel, GivesTheCubesOfTheHost)
{
    for (const auto& [kind, kernel] :
         {std::pair{TileKind::cube, "look_up_cube"}, {TileKind::wang_cube, "look_up_wang_cube"}})
        for (const HashKind hash : hashes)
            for (const Period period : {Period{}, Period{5, 6, 7}}) {
                const CubeTiling tiling(3, hash, 1, period, kind);
                const auto cubes = on_device(kernel, tiling.hash(), tiling.hash(), period);
                for (std::size_t i = 0; i < count; ++i)
                    ASSERT_EQ(cubes[i], tiling.tile(places_[3 * i], places_[3 * i + 1], places_[3 * i + 2]))
                        << kernel << " " << i;
            }
}

TEST_F(TilingKernel, GivesTheDominoesOfTheHost)
{
    for (const HashKind hash : hashes) {
        for (const std::int64_t period : {0, 77}) {
            const DominoTiling tiling(5, hash, 1, period);
            const auto dominoes = on_device("look_up_domino", tiling.hash(), tiling.hash(), {period, 0, 0});
            for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(dominoes[i], tiling.tile(places_[3 * i])) << i;
        }
    }
}

}
}
