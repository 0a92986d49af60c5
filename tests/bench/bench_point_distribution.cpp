// runtime/point_distribution.hpp, with the interface of Cortex' PointDistribution, beside the scheme that Cortex has
// behind it: recursive Wang tiles, here those of this laboratory, of 2,048 points as Kopf's own set has them.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006. Both have a
// cycle of densities: four times the density is tiles of half the side here, sixteen times is a level there. Figures
// are those of densities over a cycle, of tilings on a torus; they do not depend on the machine, but for the times, on
// one thread.
#include "analysis/measures/distance_statistics.hpp"
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "base/densities/density_text.hpp"
#include "base/geometry/relative_radius.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"
#include "host/tile_sampling/recursive/recursive_points.hpp"
#include "runtime/point_distribution.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/places.hpp"

#include <cmath>
#include <map>
#include <random>

namespace poissonlab::bench {
namespace {

constexpr std::uint32_t tilings = 10;
constexpr std::uint32_t root_tiles = 4; // along each axis of the torus of recursive tiles
constexpr std::uint32_t root_points = 2048;

struct Position
{
    double x, y;
};

struct Bounds
{
    Position min, max;
};

std::string shipped_tiles(const std::string& name)
{
    return source_folder() + "/runtime/tile_sets/" + name + ".ptiles";
}

/// The set of a seed: each seed has other tiles, whose distances differ.
const RecursiveTileSet& recursive_tiles(std::uint32_t seed)
{
    static std::map<std::uint32_t, RecursiveTileSet> built;
    const auto found = built.find(seed);
    return found != built.end() ? found->second
                                : built.emplace(seed, build_recursive_tiles(root_points, seed)).first->second;
}

/// Points on the unit torus of `side` x `side` tiles with a density of 64 `part` points a tile, times that at the
/// place.
template <class DensityFunction>
PointSet distributed_points(const std::string& name, std::uint32_t seed, int side, double part,
                            DensityFunction&& density_at)
{
    const ptiles::PointDistribution distribution(shipped_tiles(name), 0, seed, side);
    PointSet set{2, {}};
    distribution(Bounds{{0, 0}, {1.0 * side, 1.0 * side}}, static_cast<float>(part * distribution.points_per_tile()),
                 density_at, [&](const Position& p) {
                     set.coordinates.push_back(p.x / side);
                     set.coordinates.push_back(p.y / side);
                 });
    return set;
}

PointSet recursive_points(std::uint32_t seed, std::uint32_t points_per_tile, const std::optional<Density>& density)
{
    const RecursiveTiling tiling(recursive_tiles(seed), root_tiles, stream_key(seed, Purpose::recursive_tilings, 0));
    return tiling.torus_points({std::uint64_t{points_per_tile} * root_tiles * root_tiles, root_tiles, 0, density});
}

/// The root mean square of how much the number of points in a square that should hold a hundred is off, in parts: 0.1
/// for random points.
double density_error(const PointSet& set, std::uint32_t seed)
{
    constexpr int squares = 400;
    const double side = std::sqrt(100.0 / static_cast<double>(set.size()));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    double sum = 0;
    for (int n = 0; n < squares; ++n) {
        const double x = uniform(random), y = uniform(random);
        int count = 0;
        for (std::size_t i = 0; i < set.size(); ++i)
            count +=
                set[i][0] - x - std::floor(set[i][0] - x) < side && set[i][1] - y - std::floor(set[i][1] - y) < side;
        sum += (count / 100.0 - 1) * (count / 100.0 - 1);
    }
    return std::sqrt(sum / squares);
}

/// Measures sets of ten seeds, on tori of `side` tiles along each axis.
void measure_sets(benchmark::State& state, int side, const std::function<PointSet(std::uint32_t seed)>& make)
{
    double least = 1, error = 0;
    std::size_t points = 0;
    std::optional<NearLatticePeaks> peaks;
    for (auto _ : state) {
        SpectrumEstimate spectrum(2, spectrum_size(16'384, 2), true);
        for (std::uint32_t seed = 1; seed <= tilings; ++seed) {
            const PointSet set = make(seed);
            points = set.size();
            least = std::min(least, relative_radius(min_toroidal_distance(set), set.size(), 2));
            error += density_error(set, seed) / tilings;
            spectrum.add(set);
        }
        peaks = near_lattice_peaks(spectrum.mean(), side);
    }
    state.counters["points"] = static_cast<double>(points);
    state.counters["relative_radius"] = least;
    state.counters["error_percent"] = 100 * error;
    state.counters["mean_peak"] = peaks ? peaks->mean_ratio : 0;
    state.counters["excess_percent"] = peaks ? 100 * peaks->excess_share : 0;
}

/// Densities that grow from left to right from 0: how much 32 bands are off, root mean square over ten tilings, where 1
/// is what random points of that density are off.
void measure_ramp(benchmark::State& state, const std::function<PointSet(std::uint32_t seed)>& make)
{
    constexpr std::size_t bands = 32;
    double sum = 0;
    for (auto _ : state)
        for (std::uint32_t seed = 1; seed <= tilings; ++seed) {
            const PointSet set = make(seed);
            std::array<double, bands> counts{};
            for (std::size_t i = 0; i < set.size(); ++i) ++counts[static_cast<std::size_t>(set[i][0] * bands)];
            for (std::size_t b = 0; b < bands; ++b) {
                const double expected =
                    static_cast<double>(set.size()) * (2.0 * static_cast<double>(b) + 1) / (bands * bands);
                sum += (counts[b] - expected) * (counts[b] - expected) / expected / (bands * tilings);
            }
        }
    state.counters["ramp_error"] = std::sqrt(sum);
}

constexpr auto everywhere = [](const Position&) { return 1.0F; };
constexpr auto ramp = [](double side) { return [side](const Position& p) { return static_cast<float>(p.x / side); }; };

/// The counter is the processor's time of a point, in nanoseconds.
void count_nanoseconds(benchmark::State& state, std::size_t points)
{
    using benchmark::Counter;
    state.counters["ns_a_point"] =
        Counter(static_cast<double>(points) * 1e-9, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// A million points into memory that is there, on one thread.
void time_tiles(benchmark::State& state, const std::string& name, float part)
{
    const ptiles::PointDistribution distribution(shipped_tiles(name));
    std::vector<Position> points;
    const float density = part * static_cast<float>(distribution.points_per_tile());
    const double side = std::sqrt(1e6 / density);
    for (auto _ : state) {
        points.clear();
        distribution(Bounds{{0, 0}, {side, side}}, density, [&](const Position& p, float) { points.push_back(p); });
        benchmark::DoNotOptimize(points.data());
    }
    count_nanoseconds(state, points.size());
}

/// A million points of recursive tiles, by a window of all the torus.
void time_recursive(benchmark::State& state, std::uint32_t points_per_tile)
{
    const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(1e6 / points_per_tile)));
    const RecursiveTiling tiling(recursive_tiles(1), side, stream_key(1, Purpose::recursive_tilings, 0));
    const RecursiveDensity density(std::uint64_t{points_per_tile} * side * side, side, 0, std::nullopt);
    const RecursiveFrame frame({}, {side, side});
    std::size_t points = 0;
    for (auto _ : state) {
        const auto found = points_in_frame(tiling.tiles(), frame, tiling.roots(), density);
        points = found.size();
        benchmark::DoNotOptimize(found.data());
    }
    count_nanoseconds(state, points);
}

void add_once(const std::string& name, const std::function<void(benchmark::State&)>& body)
{
    benchmark::RegisterBenchmark(name.c_str(), caught(body))->Iterations(1)->Unit(benchmark::kSecond);
}

void add_time(const std::string& name, const std::function<void(benchmark::State&)>& body)
{
    benchmark::RegisterBenchmark(name.c_str(), caught(body))->Repetitions(5)->Unit(benchmark::kMillisecond);
}

/// `percent` of whole tiles, and as many tiles as have some 16,384 points.
void add_tiles(const std::string& name, int percent)
{
    const double part = percent / 100.0;
    const int side = static_cast<int>(std::lround(std::sqrt(16'384 / (64 * part))));
    const std::string which = name.substr(7) + "_" + std::to_string(percent);
    add_once("tiles_" + which, [=](benchmark::State& state) {
        measure_sets(state, side,
                     [&](std::uint32_t seed) { return distributed_points(name, seed, side, part, everywhere); });
    });
    add_time("time_tiles_" + which,
             [=](benchmark::State& state) { time_tiles(state, name, static_cast<float>(part)); });
}

void add_recursive(std::uint32_t points_per_tile)
{
    add_once("recursive_" + std::to_string(points_per_tile), [=](benchmark::State& state) {
        measure_sets(state, root_tiles,
                     [&](std::uint32_t seed) { return recursive_points(seed, points_per_tile, std::nullopt); });
    });
    add_time("time_recursive_" + std::to_string(points_per_tile),
             [=](benchmark::State& state) { time_recursive(state, points_per_tile); });
}

}
}

int main(int argc, char** argv)
{
    using namespace poissonlab;
    using namespace poissonlab::bench;
    for (const char* name : {"corner-c4-n64-r075", "corner-c4-n64-r085"})
        for (const int percent : {100, 70, 50, 35, 26}) add_tiles(name, percent);
    for (const std::uint32_t points : {1024U, 2048U, 4096U, 8192U}) add_recursive(points);
    add_once("ramp_tiles", [](benchmark::State& state) {
        measure_ramp(
            state, [](std::uint32_t seed) { return distributed_points("corner-c4-n64-r085", seed, 24, 1, ramp(24)); });
    });
    add_once("ramp_recursive", [](benchmark::State& state) {
        const Density density = density_of_formula("x + 1", 1, 1);
        measure_ramp(state, [&](std::uint32_t seed) { return recursive_points(seed, 1152, density); });
    });
    return run_benchmarks(
        argc, argv,
        {{"relative radius of whole tiles / of recursive ones", "tiles_c4-n64-r085_100/", "recursive_2048/", 1.5,
          "relative_radius"},
         {"at half of their points", "tiles_c4-n64-r085_50/", "recursive_2048/", 1, "relative_radius"},
         {"error of the density of recursive tiles / of whole tiles", "recursive_2048/", "tiles_c4-n64-r085_100/", 1,
          "error_percent"},
         {"time of recursive tiles / of tiles", "time_recursive_4096/", "time_tiles_c4-n64-r085_100/", 1,
          "ns_a_point"}});
}
