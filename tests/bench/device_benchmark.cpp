// Measures a device: its launches, memory and arithmetic, and methods beside these. Prints a section of
// docs/performance.md; `./lab bench --device NAME --short` puts it there.
//
// Usage: device_benchmark DEVICE. Ends with status 1 where the device makes other points than the plain twins.
#include "base/geometry/relative_radius.hpp"
#include "host/device/device_needs.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace poissonlab::bench {
namespace {

double seconds_of(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The least time of some runs, after one that compiles kernels: others than this program only make it longer.
double least_seconds(int runs, const std::function<void()>& work)
{
    work();
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < runs; ++i) least = std::min(least, seconds_of(work));
    return least;
}

constexpr const char* yardsticks = R"(
kernel void touch(global uint* word) { if (get_global_id(0) == 0) word[0] += 1; }

kernel void copy(global const uint4* from, global uint4* to) { to[get_global_id(0)] = from[get_global_id(0)]; }

kernel void add_products(uint turns, float by, global float* result)
{
    float8 a = (float)get_global_id(0), b = a + 1, c = a + 2, d = a + 3;
    for (uint i = 0; i < turns; ++i) { a = mad(a, by, by); b = mad(b, by, by); c = mad(c, by, by); d = mad(d, by, by); }
    const float8 sum = a + b + c + d;
    result[get_global_id(0)] = sum.s0 + sum.s1 + sum.s2 + sum.s3 + sum.s4 + sum.s5 + sum.s6 + sum.s7;
}

kernel void multiply_words(uint turns, uint by, global uint* result)
{
    ulong a = get_global_id(0), b = a + 1, c = a + 2, d = a + 3;
    for (uint i = 0; i < turns; ++i) {
        a = (a & 0xffffffffu) * by + (a >> 32);
        b = (b & 0xffffffffu) * by + (b >> 32);
        c = (c & 0xffffffffu) * by + (c >> 32);
        d = (d & 0xffffffffu) * by + (d >> 32);
    }
    result[get_global_id(0)] = (uint)(a + b + c + d);
}
)";

/// The most that the device has, as far as plain kernels come to it.
struct Yardsticks
{
    double waited_launch; ///< seconds
    double launch;        ///< of many in a row
    double bytes;         ///< per second, read and written
    double operations;    ///< of floats, per second
    double products;      ///< of 32-bit words with sums of 64 bits, per second
};

Yardsticks measure(Device& device)
{
    constexpr std::size_t words = std::size_t{1} << 24, items = std::size_t{1} << 16;
    constexpr std::uint32_t turns = 512;
    constexpr int launches = 256;
    Buffer<std::uint32_t> from = device.buffer<std::uint32_t>(words), to = device.buffer<std::uint32_t>(words);
    Buffer<float> sums = device.buffer<float>(items);
    from.write(std::vector<std::uint32_t>(words, 1));
    const auto kernel = [&](const char* name) { return device.kernel_from_text(yardsticks, "yardsticks.cl", name); };
    Kernel touch = kernel("touch"), copy = kernel("copy"), add = kernel("add_products"),
           multiply = kernel("multiply_words");
    Yardsticks found{};
    found.waited_launch = least_seconds(100, [&] {
        touch.run(1, 1, to);
        device.finish();
    });
    found.launch = least_seconds(5,
                                 [&] {
                                     for (int i = 0; i < launches; ++i) touch.run(1, 1, to);
                                     device.finish();
                                 }) /
                   launches;
    const double copying = least_seconds(5, [&] {
        copy.run(words / 4, default_work_group_size, from, to);
        device.finish();
    });
    found.bytes = 2 * sizeof(std::uint32_t) * words / copying;
    const double adding = least_seconds(3, [&] {
        add.run(items, default_work_group_size, turns, 0.5F, sums);
        device.finish();
    });
    found.operations = 2.0 * 32 * turns * items / adding;
    const double multiplying = least_seconds(3, [&] {
        multiply.run(items, default_work_group_size, turns, std::uint32_t{0x9E3779B1}, to);
        device.finish();
    });
    found.products = 4.0 * turns * items / multiplying;
    return found;
}

/// A method at a number of points.
struct Work
{
    std::string name;
    std::vector<std::string> kernels;
    std::size_t points;
    std::function<PointSet(Device&)> make;
    std::function<PointSet()> plain; ///< the twin; empty: none that has the same bytes
    double moves = 1;                ///< that the time is divided by
    double bytes = 0;                ///< a point and move has to read and write; 0: that is not fixed
    double operations = 0;           ///< of floats
};

Work darts(std::size_t n)
{
    DartThrowingRequest request;
    request.min_distance = min_distance_for(0.75, n, 2);
    request.points = n;
    request.stream = stream_key(1, Purpose::dart_throwing, 0);
    return {.name = "dart throwing at 0.75",
            .kernels = {"dart_throwing.cl"},
            .points = n,
            .make = [request](Device& device) { return DartThrower(device).throw_darts(request); },
            .plain = [request] { return reference::throw_darts(request); }};
}

Work relaxation_darts(std::size_t n)
{
    RelaxationDartThrowingRequest request;
    request.points = n;
    request.stream = stream_key(1, Purpose::relaxation_dart_throwing, 0);
    return {.name = "relaxation dart throwing",
            .kernels = {"relaxation_dart_throwing.cl"},
            .points = n,
            .make = [request](Device& device) { return RelaxationDartThrower(device).throw_darts(request).points; },
            .plain = [request] { return reference::throw_relaxation_darts(request).points; }};
}

/// Bytes: the point and its number are read and written when they are sorted (2 x 20), its cell and place (2 x 8), its
/// fixed point (8, read once more); its results are written and read (2 x 40), and its position again (2 x 16).
/// Operations: about 24 points are looked at in some 3.5 steps of two walks, with 12 operations each.
Work lloyd(std::size_t n)
{
    const PointSet start = darts(n).plain();
    const std::size_t moves = n < 100000 ? 200 : 20; // so many that setting up hardly counts
    return {.name = "Lloyd relaxation, an iteration",
            .kernels = {"point_grid.cl", "voronoi_2d.cl", "relaxation.cl"},
            .points = n,
            .make = [start, moves](Device& device) { return LloydRelaxation(device).relax(start, {}, {moves}).points; },
            .plain = {},
            .moves = static_cast<double>(moves),
            .bytes = 184,
            .operations = 2000};
}

std::string share(double needed, double had)
{
    return needed == 0 ? "" : std::to_string(static_cast<int>(100 * needed / had + 0.5)) + " %";
}

/// Prints the row of a work. Returns false where the points are others than the twin's.
bool tell(Device& device, const Work& work, const Yardsticks& most)
{
    const std::string lacks = lacking(needs_of(work.kernels), device.info());
    if (!lacks.empty()) {
        std::printf("| %s | %zu | needs %s | | | |\n", work.name.c_str(), work.points, lacks.c_str());
        return true;
    }
    const PointSet points = work.make(device);
    const double seconds = least_seconds(3, [&] { work.make(device); }) / work.moves;
    const bool is_same = !work.plain || work.plain() == points;
    const double each = static_cast<double>(work.points) / seconds;
    std::printf("| %s | %zu | %.3f ms | %s | %s | %s |\n", work.name.c_str(), work.points, seconds * 1e3,
                !work.plain ? ""
                : is_same   ? "yes"
                            : "**no**",
                share(work.bytes * each, most.bytes).c_str(), share(work.operations * each, most.operations).c_str());
    std::fflush(stdout);
    return is_same;
}

bool tell_all(Device device)
{
    const DeviceInfo& info = device.info();
    std::printf("## On %s\n\n%s, driver %s, %u compute units.\n\n", info.name.c_str(), info.platform.c_str(),
                info.driver_version.c_str(), info.compute_units);
    const Yardsticks most = measure(device);
    std::printf(
        "| what plain kernels come to | |\n| --- | --- |\n| a launch, waited for | %.1f us |\n| a launch among many | "
        "%.1f us |\n| memory, read and written | %.1f GB/s |\n| operations of floats | %.1f G/s |\n| products of "
        "32-bit "
        "words | %.1f G/s |\n\n",
        most.waited_launch * 1e6, most.launch * 1e6, most.bytes / 1e9, most.operations / 1e9, most.products / 1e9);
    std::printf("| method | points | time | bytes of the twin | of memory | of operations |\n"
                "| --- | --- | --- | --- | --- | --- |\n");
    bool are_same = true;
    std::vector<std::size_t> sizes{256, 4096};
    if (!ends_loops_early(info.name)) sizes.insert(sizes.end(), {16384, 262144});
    for (const std::size_t n : sizes)
        for (const Work& work : {darts(n), relaxation_darts(n), lloyd(n)})
            are_same = tell(device, work, most) && are_same;
    return are_same;
}

}
}

int main(int argc, char** argv)
{
    try {
        return poissonlab::bench::tell_all(poissonlab::Device::open(argc > 1 ? argv[1] : "")) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "device_benchmark: error: %s\n", error.what());
        return 3;
    }
}
