// Points and objects that follow densities: warping, lights of an environment map, the object distribution function,
// and the search of the self-similar tile.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007: 3,200 lights in about 150 ms (figure 7.1), a look-up as costly
// as five calls of Perlin's noise in 2D and twenty in 3D (7.6.2.1), 20 points searched in three and a half days
// (4.7.2.2), some 40,000 dots of a picture in about 80 ms (figure 7.4).
#include "host/distribution/even_points.hpp"
#include "host/distribution/object_shapes.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/self_similar_search.hpp"
#include "host/distribution/sky_lights.hpp"
#include "host/distribution/stipple.hpp"
#include "host/distribution/tabled_noise.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <algorithm>
#include <fstream>
#include <random>

namespace {

using namespace poissonlab;

constexpr std::size_t warped_points = 1'000'000;

/// Smooth hills, 1,024 x 1,024.
const Density& hills()
{
    static const Density density = [] {
        std::vector<double> values;
        for (int y = 0; y < 1024; ++y)
            for (int x = 0; x < 1024; ++x) values.push_back(1.02 + std::sin(x / 40.0) * std::cos(y / 55.0 + x / 200.0));
        return density_of_values(1024, 1024, values, "hills");
    }();
    return density;
}

const SquarePoints& random_square()
{
    static const SquarePoints points = [] {
        std::mt19937 random(1);
        SquarePoints all;
        while (all.size() < 2 * warped_points) all.push_back(static_cast<std::uint32_t>(random()));
        return all;
    }();
    return points;
}

/// The program that one would write: sums as they are, two binary searches, two divisions.
void warp_plainly(benchmark::State& state)
{
    const WarpTable table(hills());
    const SquarePoints& points = random_square();
    std::vector<double> places(points.size());
    const auto place = [](std::span<const std::uint64_t> sums, std::uint32_t u) {
        const auto t = static_cast<std::uint64_t>(u / 4294967296.0 * static_cast<double>(sums.back()));
        const auto cell = std::upper_bound(sums.begin(), sums.end(), t) - sums.begin() - 1;
        const auto k = static_cast<std::size_t>(cell);
        return static_cast<double>(cell) +
               static_cast<double>(t - sums[k]) / static_cast<double>(sums[k + 1] - sums[k]);
    };
    const std::size_t stride = std::size_t{table.width} + 1;
    for (auto _ : state) {
        for (std::size_t i = 0; i < points.size(); i += 2) {
            const double y = place(table.row_sums, points[i + 1]);
            places[i + 1] = y;
            places[i] = place(std::span(table.sums).subspan(static_cast<std::size_t>(y) * stride, stride), points[i]);
        }
        benchmark::DoNotOptimize(places.data());
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(warped_points) * state.iterations());
}

void warp_by_kernel(benchmark::State& state)
{
    Device device = Device::open();
    const WarpTable table(hills());
    PointWarper warper(device, table);
    auto points = device.buffer<std::uint32_t>(2 * warped_points);
    auto places = device.buffer<std::uint64_t>(2 * warped_points);
    points.write(random_square());
    const auto warp = [&] {
        warper.warp(points, warped_points, places);
        device.finish();
    };
    warp();
    for (auto _ : state) warp();
    state.SetItemsProcessed(static_cast<std::int64_t>(warped_points) * state.iterations());
}

PoissonTileSet shipped(const char* name) { return read_tile_set(source_folder() + "/runtime/tile_sets/" + name); }

/// The way from a file of floating-point colours to the files of places and lights. The tiles are there.
void lights_of_a_sky(benchmark::State& state)
{
    const TemporaryFolder folder;
    const auto map_file = folder.path() / "sky.pfm";
    std::ofstream file(map_file, std::ios::binary);
    file << "PF\n1024 512\n-1.0\n";
    for (int row = 0; row < 512; ++row)
        for (int column = 0; column < 1024; ++column)
            for (int c = 0; c < 3; ++c) {
                const float value = 0.2f + static_cast<float>((row * 7 + column * 13 + c) % 97) / 97;
                file.write(reinterpret_cast<const char*>(&value), sizeof value);
            }
    file.close();
    const PoissonTileSet tiles = shipped("corner-c8-n32-r075.ptiles");
    const DistributionPlace place{Engine::opencl, []() -> Device& {
                                      static Device device = Device::open();
                                      return device;
                                  }};
    for (auto _ : state) {
        const LinearPicture map = sky_map(map_file.string());
        const Density density = sky_density(map, "sky");
        const PixelPlaces places = warp_points(density, even_points(tiles, 3200, 2, 1, 1, place, Seam::closed), place);
        write_places(folder.path() / "places.npy", places, 1024, "");
        std::ofstream(folder.path() / "lights.csv") << lights_text(sky_lights(map, places, SeenFrom::inside));
    }
}

/// A picture of 1,024 x 1,024 pixels in memory becomes 40,000 dots; pictures are not drawn.
void stipple_40000_dots(benchmark::State& state, MarkPlaces by)
{
    static Device device = Device::open();
    const DistributionPlace place{Engine::opencl, []() -> Device& { return device; }};
    InkPicture picture{{1024, 1024, {}}, hills(), 0};
    for (const std::uint64_t weight : hills().weights) {
        picture.ink.values.push_back(0.5 * static_cast<double>(weight) / static_cast<double>(full_weight));
        picture.total += picture.ink.values.back();
    }
    StippleSettings settings;
    settings.points = 40'000;
    settings.by = by;
    settings.method.tiles = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
    stipple(picture, settings, 1, place); // builds kernels
    for (auto _ : state) benchmark::DoNotOptimize(stipple(picture, settings, 1, place).marks.disks.size());
}

/// Places without order, or along rows that are a thirtieth of the points' distance apart.
template <int dimension>
struct Places
{
    explicit Places(bool along_rows)
    {
        std::mt19937 random(2);
        for (std::size_t i = 0; i < positions.size(); ++i)
            for (std::size_t a = 0; a < 3; ++a)
                positions[i][a] = along_rows ? (a == 0   ? static_cast<double>(i % 256) / 180
                                                : a == 1 ? static_cast<double>(i / 256) / 180
                                                         : 0.37)
                                             : static_cast<double>(random() % (1 << 24)) / (1 << 14);
    }
    std::vector<std::array<double, 3>> positions = std::vector<std::array<double, 3>>(1 << 14);
};

template <int dimension>
void perlin(benchmark::State& state, bool along_rows)
{
    const TabledNoise noise;
    const Places<dimension> places(along_rows);
    for (auto _ : state) {
        double sum = 0;
        for (const auto& p : places.positions)
            if constexpr (dimension == 2)
                sum += noise.at(p[0] * 8, p[1] * 8);
            else
                sum += noise.at(p[0] * 8, p[1] * 8, p[2] * 8);
        benchmark::DoNotOptimize(sum);
    }
}

template <int dimension>
const char* set_name()
{
    return dimension == 2 ? "corner-c8-n32-r075.ptiles" : "sphere-c2-n128-r075.ptiles";
}

template <int dimension>
void objects(benchmark::State& state, bool along_rows)
{
    const ObjectTileSet tiles(shipped(set_name<dimension>()));
    const pobjects distribution = tiles.distribution({1, 0});
    const Places<dimension> places(along_rows);
    pobjects_cursor cursor{};
    for (auto _ : state) {
        std::uint32_t sum = 0;
        for (const auto& p : places.positions)
            sum += pobjects_at(&distribution, p.data(), along_rows ? &cursor : nullptr).point.id;
        benchmark::DoNotOptimize(sum);
    }
}

template <int dimension>
void nearest(benchmark::State& state, bool along_rows)
{
    const PoissonTileSet tiles = shipped(set_name<dimension>());
    const ptiles_tiling tiling = runtime_tiling(tiles, {1, 0});
    const Places<dimension> places(along_rows);
    for (auto _ : state) {
        std::uint32_t sum = 0;
        for (const auto& p : places.positions) {
            ptiles_point point;
            ptiles_nearest(&tiling, p.data(), &point);
            sum += point.id;
        }
        benchmark::DoNotOptimize(sum);
    }
}

void search_of_20_points(benchmark::State& state)
{
    Device device = Device::open();
    search_self_similar(device, 8, 0.5); // builds the kernel
    for (auto _ : state) benchmark::DoNotOptimize(search_self_similar(device, 20, 0.65));
}

constexpr auto perlin_2d = perlin<2>, perlin_3d = perlin<3>;
constexpr auto objects_2d = objects<2>, objects_3d = objects<3>;
constexpr auto nearest_2d = nearest<2>, nearest_3d = nearest<3>;

BENCHMARK(warp_plainly)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(warp_by_kernel)->Repetitions(15)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(lights_of_a_sky)->Repetitions(5)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(stipple_40000_dots, warping, MarkPlaces::warping)
    ->Repetitions(9)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(stipple_40000_dots, ranks, MarkPlaces::ranks)
    ->Repetitions(9)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(stipple_40000_dots, gaussian, MarkPlaces::gaussian)
    ->Repetitions(3)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(perlin_2d, random, false)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(perlin_2d, rows, true)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(perlin_3d, random, false)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(perlin_3d, rows, true)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(objects_2d, random, false)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(objects_2d, rows, true)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(objects_3d, random, false)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(objects_3d, rows, true)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(nearest_2d, random, false)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(nearest_2d, rows, true)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(nearest_3d, random, false)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(nearest_3d, rows, true)->Repetitions(9)->Unit(benchmark::kMicrosecond);
BENCHMARK(search_of_20_points)->Iterations(1)->Repetitions(3)->Unit(benchmark::kSecond)->UseRealTime();

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"warping: speed over plain binary searches", "warp_plainly/", "warp_by_kernel/", 8},
         {"objects in 2D: Perlin's noise / a look-up, random order", "perlin_2d/random/", "objects_2d/random/", 0.2},
         {"objects in 2D: Perlin's noise / a look-up, along rows", "perlin_2d/rows/", "objects_2d/rows/", 0},
         {"objects in 3D: Perlin's noise / a look-up, random order", "perlin_3d/random/", "objects_3d/random/", 0.05},
         {"objects in 3D: Perlin's noise / a look-up, along rows", "perlin_3d/rows/", "objects_3d/rows/", 0},
         {"objects in 2D: speed over the nearest point, random order", "nearest_2d/random/", "objects_2d/random/", 0},
         {"objects in 2D: speed over the nearest point, along rows", "nearest_2d/rows/", "objects_2d/rows/", 2},
         {"objects in 3D: speed over the nearest point, random order", "nearest_3d/random/", "objects_3d/random/", 0},
         {"objects in 3D: speed over the nearest point, along rows", "nearest_3d/rows/", "objects_3d/rows/", 0}},
        {{"lights of a sky, 1,024 x 512 pixels, 3,200 lights, from file to file (ms)", "lights_of_a_sky/", 150},
         {"stippling, 1,024 x 1,024 pixels, 40,000 dots by warping (ms)", "stipple_40000_dots/warping/", 80},
         {"stippling, 1,024 x 1,024 pixels, 40,000 dots by ranks (ms)", "stipple_40000_dots/ranks/", 80},
         {"the search of 20 points (s)", "search_of_20_points/", 10}});
}
