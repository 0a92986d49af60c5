// Times of points of three classes in a polygon of 10,000 corners, compared with as many points of one class. Times
// leave out the building of kernels, reading, drawing and writing.
#include "host/distribution/classes/class_points.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "tests/bench/ratio_reporter.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace poissonlab;

constexpr std::size_t points = 1'000'000;

/// A disk of radius 400 with seven wide and 400 small bays.
const std::string& polygon()
{
    static const std::string text = [] {
        constexpr int corners = 10'000;
        std::string ring;
        for (int i = 0; i <= corners; ++i) {
            const double angle = 2 * std::numbers::pi * (i % corners) / corners;
            const double radius = 400 + 40 * std::sin(7 * angle) + 3 * std::sin(400 * angle);
            ring +=
                fmt::format("{}{:.6f} {:.6f}", i > 0 ? ", " : "", radius * std::cos(angle), radius * std::sin(angle));
        }
        return fmt::format("POLYGON (({}))", ring);
    }();
    return text;
}

const DistributionPlace& place()
{
    static Device device = Device::open({}, 2);
    static const DistributionPlace place{Engine::opencl, []() -> Device& { return device; }};
    return place;
}

/// Makes a few points, for which the kernels are built.
void build(ClassSettings settings)
{
    settings.points = {1, 4, 16};
    throw_classes(settings, 0, place());
}

void build(RegionPointSettings settings)
{
    settings.place.points = 21;
    make_region_points(settings, 0, place());
}

void three_classes(benchmark::State& state)
{
    ClassSettings settings;
    settings.place.region = polygon();
    settings.points = {points / 21, 4 * points / 21, points - points / 21 - 4 * points / 21};
    build(settings);
    std::uint64_t seed = 0;
    for (auto _ : state) benchmark::DoNotOptimize(throw_classes(settings, ++seed, place()));
}

void one_class(benchmark::State& state)
{
    RegionPointSettings settings;
    settings.method = RegionMethod::darts;
    settings.place.region = polygon();
    settings.place.points = points;
    build(settings);
    std::uint64_t seed = 0;
    for (auto _ : state) benchmark::DoNotOptimize(make_region_points(settings, ++seed, place()));
}

BENCHMARK(three_classes)->Iterations(1)->Repetitions(5)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK(one_class)->Iterations(1)->Repetitions(5)->Unit(benchmark::kSecond)->UseRealTime();

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"one class over three classes, a million points in a polygon of 10,000 corners", "one_class/",
          "three_classes/", 0}},
        {{"a million points of three classes in a polygon of 10,000 corners (s)", "three_classes/", 5}});
}
