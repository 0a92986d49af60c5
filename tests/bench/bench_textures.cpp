// Texture tiles: candidates by transforms against all products, whole sets, and views of the endless plane against
// those of a texture that repeats.
//
// Targets: the candidates of a piece of 64 x 64 pixels in an exemplar of 512 x 512 in a twentieth of the time that the
// plain sums take; a complete set of corner tiles over three colours in a second, over four in three, on two cores, and
// one over three that is chosen together in ten; a view of the plane in 2.5 times what the atlas takes that repeats,
// with the same filter, packed or exact, and packed in no more time than the same view of hexagons, which take three
// look-ups; endless textures of hexagons and of by-example noise, 1,920 x 1,080 pixels on
// one thread, in 1.5 times what a plain loop takes.
#include "host/device/device.hpp"
#include "host/texture/endless/endless_texture.hpp"
#include "host/texture/mapping/endless_map.hpp"
#include "host/texture/mapping/texture_map.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/host/texture/plain_masked_squares.hpp"
#include "tests/host/texture/random_picture.hpp"

namespace {

using namespace poissonlab;

constexpr int exemplar_size = 512;
constexpr int tile_size = 64;

const PngPixels& exemplar()
{
    static const PngPixels picture = test::random_picture(exemplar_size, exemplar_size, 1, 1);
    return picture;
}

/// The ring in which the middle of a tile is cut.
PieceMask ring_mask()
{
    PieceMask mask{tile_size, tile_size, {}};
    for (int y = 0; y < tile_size; ++y)
        for (int x = 0; x < tile_size; ++x) {
            const int dx = 2 * x + 1 - tile_size, dy = 2 * y + 1 - tile_size;
            const int square = dx * dx + dy * dy;
            mask.counts.push_back(square < 56 * 56 && square > 4 * 4);
        }
    return mask;
}

void sums_by_transforms(benchmark::State& state)
{
    const MaskedSquares squares(exemplar(), ring_mask());
    const PngPixels piece = window_pixels(exemplar(), {100, 100, tile_size});
    for (auto _ : state) benchmark::DoNotOptimize(squares.sums(piece).sums.data());
}

void sums_one_by_one(benchmark::State& state)
{
    const PieceMask mask = ring_mask();
    const PngPixels piece = window_pixels(exemplar(), {100, 100, tile_size});
    for (auto _ : state) benchmark::DoNotOptimize(test::plain_masked_squares(exemplar(), mask, piece).sums.data());
}

void corner_set(benchmark::State& state)
{
    TextureRequest request;
    request.colors = {static_cast<Color>(state.range(0)), static_cast<Color>(state.range(0))};
    const auto go_on = [](const std::string&, std::size_t, std::size_t) {};
    for (auto _ : state) benchmark::DoNotOptimize(build_texture(request, exemplar(), go_on).cost);
}

void joint_set(benchmark::State& state)
{
    TextureRequest request;
    request.colors = {3, 3};
    request.joint = true;
    const auto go_on = [](const std::string&, std::size_t, std::size_t) {};
    for (auto _ : state) benchmark::DoNotOptimize(build_texture(request, exemplar(), go_on).cost);
}

TextureView plane_view(TextureFilter filter)
{
    TextureCamera camera;
    camera.width = 1280;
    camera.height = 720;
    camera.filter = filter;
    return view_of(camera);
}

/// The plane to the horizon, full screen. Ranges: look-up and filter.
void plane(benchmark::State& state)
{
    static const TexturePyramid pyramid = [] {
        TextureRequest request;
        request.colors = {3, 3};
        request.attempts = request.candidates = 1;
        return texture_pyramid(
            build_texture(request, exemplar(), [](const std::string&, std::size_t, std::size_t) {}).set, 1);
    }();
    const TextureView view = plane_view(static_cast<TextureFilter>(state.range(1)));
    const auto lookup = static_cast<TextureLookup>(state.range(0));
    Device device = Device::open();
    map_texture(device, pyramid, lookup, view, default_work_group_size); // builds the kernel
    for (auto _ : state)
        benchmark::DoNotOptimize(map_texture(device, pyramid, lookup, view, default_work_group_size).data());
}

/// The plane to the horizon by hexagons of the exemplar. Range: the filter.
void plane_of_hexagons(benchmark::State& state)
{
    const MappedEndless mapped = mapped_endless({}, exemplar());
    const TextureView view = plane_view(static_cast<TextureFilter>(state.range(0)));
    Device device = Device::open();
    const auto draw = [&] { return map_endless(device, mapped, mapped.origin(0, 0), view, default_work_group_size); };
    draw(); // builds the kernel
    for (auto _ : state) benchmark::DoNotOptimize(draw().data());
}

constexpr PixelWindow full_screen{0, 0, 1920, 1080};

EndlessTexture endless_of(const benchmark::State& state)
{
    static const PngPixels colored = test::random_picture(exemplar_size, exemplar_size, 3, 1);
    EndlessRequest request;
    request.method = static_cast<EndlessMethod>(state.range(0));
    return endless_texture(request, colored);
}

/// The kernel, on one thread of the processor.
void endless_kernel(benchmark::State& state)
{
    Device device = Device::open({}, 1);
    const EndlessTexture texture = endless_of(state);
    for (auto _ : state) state.SetIterationTime(endless_seconds(device, texture, full_screen));
}

void endless_loop(benchmark::State& state)
{
    const EndlessTexture texture = endless_of(state);
    for (auto _ : state) benchmark::DoNotOptimize(reference_endless_window(texture, full_screen).values.data());
}

/// Repeated, offsets, hexagons, blended.
BENCHMARK(endless_kernel)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->Repetitions(3)->UseManualTime();
BENCHMARK(endless_loop)->DenseRange(0, 3)->Unit(benchmark::kMillisecond)->Repetitions(3)->UseRealTime();

/// Look-ups packed, exact and repeated; filters bilinear, mipmap and anisotropic.
BENCHMARK(plane)->ArgsProduct({{0, 1, 3}, {1, 2, 3}})->Unit(benchmark::kMillisecond)->Repetitions(3)->UseRealTime();
BENCHMARK(plane_of_hexagons)->DenseRange(1, 3)->Unit(benchmark::kMillisecond)->Repetitions(3)->UseRealTime();
BENCHMARK(sums_by_transforms)->Unit(benchmark::kMillisecond)->Repetitions(3)->UseRealTime();
BENCHMARK(sums_one_by_one)->Unit(benchmark::kMillisecond)->Repetitions(3)->UseRealTime();
BENCHMARK(joint_set)->Unit(benchmark::kMillisecond)->Repetitions(3)->UseRealTime();
BENCHMARK(corner_set)->Arg(3)->Arg(4)->Unit(benchmark::kMillisecond)->Repetitions(3)->UseRealTime();

}

int main(int argc, char** argv)
{
    return poissonlab::bench::run_benchmarks(
        argc, argv,
        {{"sums one by one / by transforms", "sums_one_by_one/", "sums_by_transforms/", 20},
         {"repeated / packed, bilinear", "plane/3/1", "plane/0/1", 1 / 2.5},
         {"repeated / packed, mipmap", "plane/3/2", "plane/0/2", 1 / 2.5},
         {"repeated / packed, anisotropic", "plane/3/3", "plane/0/3", 1 / 2.5},
         {"repeated / exact, bilinear", "plane/3/1", "plane/1/1", 1 / 2.5},
         {"repeated / exact, mipmap", "plane/3/2", "plane/1/2", 1 / 2.5},
         {"repeated / exact, anisotropic", "plane/3/3", "plane/1/3", 1 / 2.5},
         {"hexagons / packed, bilinear", "plane_of_hexagons/1", "plane/0/1", 1},
         {"hexagons / packed, mipmap", "plane_of_hexagons/2", "plane/0/2", 1},
         {"hexagons / packed, anisotropic", "plane_of_hexagons/3", "plane/0/3", 1},
         {"plain loop / kernel, hexagons", "endless_loop/2", "endless_kernel/2", 1 / 1.5},
         {"plain loop / kernel, by-example noise", "endless_loop/3", "endless_kernel/3", 1 / 1.5}},
        {{"corner tiles of 3 colours, ms", "corner_set/3", 1000},
         {"of 4 colours, ms", "corner_set/4", 3000},
         {"of 3 colours together, ms", "joint_set/", 10000}});
}
