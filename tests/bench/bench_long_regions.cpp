// Times of methods and analyses in straight and slanting corridors, 10,000 times as long as wide, compared with a
// square of the same area and number of points; and of analyses of periodic boxes, compared with squares and cubes. The
// corridors are 1.4 mean spacings wide with 20,000 points and 3.2 with 100,000, so that most points are near the
// boundary. Times leave out the building of kernels, reading, drawing and writing.
#include "base/regions/region_text.hpp"
#include "experiment/measuring/series_analysis.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "tests/bench/ratio_reporter.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace poissonlab::bench {
namespace {

constexpr std::array<std::size_t, 2> sizes{20'000, 100'000};

/// Returns a region with an area of 10,000. The slanting corridor is turned by 30 degrees.
std::string region_text(const std::string& shape)
{
    if (shape == "square") return "rectangle 0 0 100 100";
    if (shape == "straight") return "rectangle 0 0 10000 1";
    const double x = 10'000 * std::sqrt(0.75), y = 5'000, across = std::sqrt(0.75);
    return fmt::format("POLYGON ((0.5 0, {} {}, {} {}, 0 {}, 0.5 0))", x + 0.5, y, x, y + across, across);
}

const DistributionPlace& place()
{
    static Device device = Device::open({}, 2);
    static const DistributionPlace place{Engine::opencl, []() -> Device& { return device; }};
    return place;
}

RegionPointSettings settings_of(RegionMethod method, const std::string& shape, std::size_t points)
{
    RegionPointSettings settings;
    settings.method = method;
    settings.place.region = region_text(shape);
    if (method == RegionMethod::lloyd) settings.iterations = 10;
    if (method == RegionMethod::bridson) // which takes a distance: that of darts
        settings.place.min_distance = 0.75 * std::sqrt(1e4 / static_cast<double>(points));
    else
        settings.place.points = points;
    return settings;
}

void make_points(benchmark::State& state, RegionMethod method, const std::string& shape, std::size_t points)
{
    const RegionPointSettings settings = settings_of(method, shape, points);
    make_region_points(settings, 0, place()); // builds the kernels
    std::uint64_t seed = 0;
    std::size_t made = 0;
    for (auto _ : state) made = make_region_points(settings, ++seed, place()).points.size();
    state.counters["points"] = static_cast<double>(made);
}

/// Measures all that commands do.
void analyse(const AnalysisOptions& options, const PointSet& points)
{
    SeriesAnalysis series("points", false, options);
    series.add(points);
    series.measure_spectrum(series.mean_spectrum());
    series.measure_first();
    benchmark::DoNotOptimize(series.pair_correlation());
    benchmark::DoNotOptimize(series.number_variance());
    benchmark::DoNotOptimize(series.region_curves());
}

void analyse_region(benchmark::State& state, const std::string& shape, std::size_t points)
{
    const RegionDarts darts = make_region_points(settings_of(RegionMethod::darts, shape, points), 1, place());
    const AnalysisOptions options = overridden_analysis({fmt::format("analysis.region=\"{}\"", region_text(shape))}, 2);
    for (auto _ : state) analyse(options, darts.points);
}

/// Random points in a box whose first side is so many times as long as the others. Squares and cubes have additional
/// measures, so boxes that are nearly square or cubic stand in for them.
void analyse_box(benchmark::State& state, int dimension, int factor)
{
    std::mt19937 random(1);
    PointSet points{dimension, {}};
    for (int i = 0; i < 65'536 * dimension; ++i) points.coordinates.push_back(static_cast<double>(random()) * 0x1p-32);
    AnalysisOptions options;
    options.box_sides.assign(static_cast<std::size_t>(dimension), 1);
    options.box_sides[0] = factor == 1 ? 1.001 : factor;
    for (auto _ : state) analyse(options, points);
}

template <typename Body>
void add(const std::string& name, const Body& body)
{
    benchmark::RegisterBenchmark(name.c_str(), caught(body))
        ->Repetitions(5)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
}

/// Registers a body for all shapes and sizes, and what its times have to be.
template <typename Body>
void add_shapes(std::vector<Ratio>& ratios, const std::string& what, const Body& body)
{
    for (const std::size_t points : sizes) {
        const auto name = [&](const std::string& shape) { return fmt::format("{}_{}_{}", what, shape, points); };
        for (const std::string shape : {"square", "straight", "slanting"}) {
            add(name(shape), [=](benchmark::State& state) { body(state, shape, points); });
            if (shape == "square") continue;
            ratios.push_back(
                {fmt::format("{}, {} points: time in a square over time in a {} corridor", what, points, shape),
                 name("square") + "/", name(shape) + "/", 1.0 / 2});
        }
    }
}

void add_boxes(std::vector<Ratio>& ratios, int dimension)
{
    const auto name = [&](int factor) { return fmt::format("box_{}d_{}", dimension, factor); };
    for (const int factor : {1, 4, 16}) {
        add(name(factor), [=](benchmark::State& state) { analyse_box(state, dimension, factor); });
        if (factor > 1)
            ratios.push_back({fmt::format("{}D, sides {}:1: a {}, part of the time of the periodic box", dimension,
                                          factor, dimension == 2 ? "square" : "cube"),
                              name(1) + "/", name(factor) + "/", 0.9});
    }
}

}
}

int main(int argc, char** argv)
{
    using namespace poissonlab;
    using namespace poissonlab::bench;
    std::vector<Ratio> ratios;
    for (const RegionMethod method : {RegionMethod::darts, RegionMethod::relaxation, RegionMethod::elimination,
                                      RegionMethod::lloyd, RegionMethod::gaussian, RegionMethod::bridson})
        add_shapes(ratios, region_methods[method],
                   [=](benchmark::State& state, const std::string& shape, std::size_t points) {
                       make_points(state, method, shape, points);
                   });
    add_shapes(ratios, "analyze", analyse_region);
    for (const int dimension : {2, 3}) add_boxes(ratios, dimension);
    return run_benchmarks(argc, argv, ratios);
}
