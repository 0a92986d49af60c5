// runtime/test_vectors.csv, which says what ports of the runtime must find, is what the C header finds.
#include "base/files/whole_file.hpp"
#include "tests/support/places.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

constexpr auto vector_columns =
    "set,seed,period,i,j,k,tile,index,x,y,z,id,level,fx,fy,fz,near_i,near_j,near_k,near_index,near_id,near_distance\n";

/// Coordinates in 1/65536 tile, from the tile's lowest corner.
std::string units_of(const ptiles_tiling& t, const std::uint16_t* numbers)
{
    std::string text;
    for (std::uint32_t axis = 0; axis < 3; ++axis)
        text += fmt::format(",{}", axis < t.set.dimension ? t.set.low + t.set.step * numbers[axis] : 0);
    return text;
}

/// A line: the tile at a place, one of its points, and the point nearest to a position in the tile.
std::string vector_line(const std::string& name, const ptiles_tiling& t, std::mt19937& random, bool is_far)
{
    std::int32_t place[3] = {0, 0, 0}, units[3] = {0, 0, 0};
    double position[3] = {0, 0, 0};
    for (std::uint32_t axis = 0; axis < t.set.dimension; ++axis) {
        const auto anywhere = static_cast<std::int32_t>(random());
        place[axis] = is_far ? anywhere / 2 : anywhere % 10;
        units[axis] = static_cast<std::int32_t>(random() % 65536);
        position[axis] = place[axis] + units[axis] / 65536.0;
    }
    const std::uint32_t tile = ptiles_tile(&t, place[0], place[1], place[2]);
    const auto index = static_cast<std::uint32_t>(random() % t.set.points_per_tile);
    const std::uint16_t* const numbers = ptiles_points(&t.set, tile) + index * t.set.dimension;
    const ptiles_point point = ptiles_point_at(&t, place, index, numbers);
    ptiles_point near;
    const double distance = std::sqrt(ptiles_nearest(&t, position, &near));
    return fmt::format("{},{},{},{},{},{},{},{}{},{},{},{},{},{},{},{},{},{},{},{}\n", name, t.seed, t.period, place[0],
                       place[1], place[2], tile, index, units_of(t, numbers), point.id, point.level, units[0], units[1],
                       units[2], near.tile[0], near.tile[1], near.tile[2], near.index, near.id, distance);
}

std::string all_vectors()
{
    std::string text = vector_columns;
    std::mt19937 random(1);
    for (const char* name : {"corner-c3-n64-r085", "corner-c4-n64-r075", "corner-c8-n32-r075", "sphere-c2-n128-r075"}) {
        const PoissonTileSet set = read_tile_set(source_folder() + "/runtime/tile_sets/" + name + ".ptiles");
        for (const PoissonTiling& choice :
             {PoissonTiling{1, 0}, PoissonTiling{0x89abcdef, 0}, PoissonTiling{7, 1000}}) {
            const ptiles_tiling tiling = runtime_tiling(set, choice);
            for (int n = 0; n < 8; ++n) text += vector_line(name, tiling, random, n % 2 == 1);
        }
    }
    return text;
}

TEST(TestVectors, AreWhatTheHeaderFinds)
{
    EXPECT_EQ(read_whole_file(source_folder() + "/runtime/test_vectors.csv"), all_vectors())
        << "see the file that this test leaves as test_vectors.csv";
    if (HasFailure()) write_whole_file("test_vectors.csv", all_vectors());
}

}
}
