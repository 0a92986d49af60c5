// Points on a mesh beside points of the plane: a million darts on a torus of 2,304 triangles, at a distance and by
// their number, and as many of the plane's dart throwing at the same relative radius.
//
// The floor of a dart on a surface: a random word and two searches for its piece and its place take some 40 ns of one
// core where they are in the cache, and of the eight cells nearest to it five hold a surface's eleven points, at 5 ns
// each, so 100 ns. About four and a half darts a point are 0.45 s of one core for a million points; pieces come to some
// six a point, which are looked at once at each of three sizes with the same eleven points: 1.5 s. In the plane, a dart
// looks at nine cells of two dimensions with 32-bit numbers.
#include "base/geometry/relative_radius.hpp"
#include "host/distribution/surfaces/surface_set.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/meshes.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab::bench {
namespace {

constexpr std::size_t million = 1'000'000;
constexpr double radius = 0.7;

std::shared_ptr<const SurfaceMesh> torus()
{
    SurfaceMesh made{textured_mesh(48, 24,
                                   [](double u, double v) {
                                       const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v;
                                       return MeshPoint{(1 + 0.4 * std::cos(b)) * std::cos(a),
                                                        (1 + 0.4 * std::cos(b)) * std::sin(a), 0.4 * std::sin(b)};
                                   }),
                     {}};
    made.surface = fixed_surface(made.mesh);
    return std::make_shared<const SurfaceMesh>(std::move(made));
}

void on_surface(benchmark::State& state, MeshPointSettings settings)
{
    Device device = Device::open();
    settings.read = torus();
    settings.points = million;
    for (auto _ : state) {
        const SurfaceSet set =
            make_surface_set(settings, 1, {.engine = Engine::opencl, .device = [&]() -> Device& { return device; }});
        if (set.points.size() != million) state.SkipWithError("there are not a million points");
    }
}

void surface_at_radius(benchmark::State& state)
{
    MeshPointSettings settings;
    settings.relative_radius = radius;
    on_surface(state, settings);
}

void surface_by_count(benchmark::State& state) { on_surface(state, {}); }

void plane_at_radius(benchmark::State& state)
{
    DartThrower method(Device::open());
    DartThrowingRequest request;
    request.dimension = 2;
    request.min_distance = min_distance_for(radius, million, 2);
    request.points = million;
    request.stream = stream_key(1, Purpose::dart_throwing, 0);
    for (auto _ : state) benchmark::DoNotOptimize(method.throw_darts(request));
}

BENCHMARK(surface_at_radius)->Iterations(1)->Repetitions(3)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(surface_by_count)->Iterations(1)->Repetitions(3)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(plane_at_radius)->Iterations(1)->Repetitions(3)->Unit(benchmark::kMillisecond)->UseRealTime();

}
}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"a million points on a torus at 0.70 / as many darts in the plane", "surface_at_radius/", "plane_at_radius/"},
         {"a million points on a torus by count / as many darts in the plane", "surface_by_count/",
          "plane_at_radius/"}});
}
