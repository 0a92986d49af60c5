// Every method at 16,384, 262,144 and 1,048,576 points (3D: 65,536 and 1,048,576): a line each with the time, points a
// second, how the time grows, and the most memory that the process had.
//
// Each set is made in a process of its own, whose memory nothing else has used, after a small one, which builds the
// kernels. A process that takes more than two minutes of processors' time is ended, and larger sets are not tried then.
// The exponent is of that time, which other work on the machine changes less: n to 1.15 n log n allows between the last
// two sizes, whose logarithms' ratio is 20 / 18, which is an exponent of 1.08. Numbers of moves are small: they are the
// same at each size, and a method's time is their number times that of one.
//
// With --csv: docs/gallery/sizes.csv, at 10^4 to 10^7 points, as far as sets are expected within half a minute.
#include "experiment/config/config.hpp"
#include "experiment/config/plan.hpp"
#include "host/device/device.hpp"
#include "host/sampling/sampler.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace poissonlab::bench {
namespace {

constexpr int most_seconds = 120; ///< of all processors together
constexpr double most_exponent = 1.15;
constexpr std::size_t small_set = 2048;

struct Method
{
    int dimension;
    std::string name;
    std::string table; ///< its keys beside the name, with commas between them
};

const std::vector<Method> methods = {
    {2, "random", ""},
    {2, "jittered", ""},
    {2, "sobol", ""},
    {2, "halton", ""},
    {2, "best-candidate", ""},
    {2, "bridson", ""},
    {2, "dart-throwing", "relative_radius = 0.75"},
    {2, "dart-throwing", "stop = \"saturation\""},
    {2, "relaxation-dart-throwing", ""},
    {2, "voronoi-darts", "relative_radius = 0.75"},
    {2, "sector-darts", ""},
    {2, "lloyd", "iterations = 2"},
    {2, "sample-elimination", ""},
    {2, "farthest-point", "iterations = 2"},
    {2, "gaussian-blue-noise", "iterations = 5"},
    {2, "target-spectrum", "iterations = 3"},
    {2, "equal-areas", "iterations = 2"},
    {2, "penrose", ""},
    {2, "polyominoes", ""},
    {2, "isohedral-tiles", ""},
    {2, "corner-tiles", "colors = 3, points_per_tile = 32, border = \"chain\""},
    {2, "edge-tiles", "colors = 2, points_per_tile = 32"},
    {2, "template-tiles", "tiles = 64, points_per_tile = 32"},
    {2, "recursive-wang-tiles", ""},
    {3, "random", ""},
    {3, "bridson", ""},
    {3, "dart-throwing", "relative_radius = 0.65"},
    {3, "dart-throwing", "stop = \"saturation\""},
    {3, "relaxation-dart-throwing", ""},
    {3, "lloyd", "iterations = 2"},
    {3, "sample-elimination", ""},
    {3, "gaussian-blue-noise", "iterations = 5"},
    {3, "sphere-tiles", "colors = 2, points_per_tile = 64, relative_radius = 0.65"},
};

struct Figures
{
    double seconds = 0;
    double processor_seconds = 0;
    std::size_t points = 0;
    double peak_mebibytes = 0;
};

std::string name_of(const Method& method)
{
    return method.name + " " + std::to_string(method.dimension) + "D" +
           (method.table.empty() ? "" : ", " + method.table);
}

double processor_seconds()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

PointSet set_of(const Method& method, std::size_t points)
{
    const std::string keys = std::regex_replace(method.table, std::regex(", "), "\n");
    const std::string config = "seed = 1\n[analysis]\npoints = " + std::to_string(points) +
                               "\ndimension = " + std::to_string(method.dimension) + "\n[[method]]\nsampler = \"" +
                               method.name + "\"\n" + keys + "\n";
    const std::vector<SeriesPlan> plan = make_plan(parse_config(config, "bench_scale"));
    const SeriesPlan& series = plan.front();
    Device device = Device::open();
    return series.sampler
        ->create(series.parameters, series.request, Engine::opencl, [&]() -> Device& { return device; })
        ->sample(0);
}

/// Makes the set in a child process, and writes its figures into the pipe.
[[noreturn]] void measure(const Method& method, std::size_t points, int pipe)
{
    set_of(method, small_set);
    const itimerval limit{{0, 0}, {most_seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    Figures figures;
    const double before = processor_seconds();
    const auto start = std::chrono::steady_clock::now();
    figures.points = set_of(method, points).size();
    figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    figures.processor_seconds = processor_seconds() - before;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    figures.peak_mebibytes = static_cast<double>(usage.ru_maxrss) / 1024; // Linux: KiB
    const bool is_written = write(pipe, &figures, sizeof figures) == sizeof figures;
    _exit(is_written ? 0 : 1);
}

/// Returns the figures of a set; nothing, and a word why, where there is no set. This process never opens a device: a
/// child could not use it.
std::optional<Figures> figures_of(const Method& method, std::size_t points, std::string& why)
{
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) throw std::runtime_error("no pipe");
    std::fflush(stdout);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        try {
            measure(method, points, pipe_ends[1]);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
            _exit(1);
        }
    }
    close(pipe_ends[1]);
    Figures figures;
    const bool is_whole = read(pipe_ends[0], &figures, sizeof figures) == sizeof figures;
    close(pipe_ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (is_whole) return figures;
    why = WIFSIGNALED(status) && WTERMSIG(status) == SIGPROF
              ? "ended after " + std::to_string(most_seconds) + " s of processors"
              : "failed";
    return std::nullopt;
}

double exponent_between(const Figures& before, const Figures& figures)
{
    return std::log(figures.processor_seconds / before.processor_seconds) /
           std::log(static_cast<double>(figures.points) / static_cast<double>(before.points));
}

/// True where the time grows as it should, as far as it is known.
bool tell_growth(const Method& method)
{
    const std::vector<std::size_t> sizes = method.dimension == 2 ? std::vector<std::size_t>{16'384, 262'144, 1'048'576}
                                                                 : std::vector<std::size_t>{65'536, 1'048'576};
    std::optional<Figures> before;
    bool is_reached = true;
    for (const std::size_t size : sizes) {
        std::string why;
        const auto figures = figures_of(method, size, why);
        std::printf("%-52s %8zu ", name_of(method).c_str(), size);
        if (!figures) {
            std::printf("%s\n", why.c_str());
            return false;
        }
        std::printf("%9.3f s %9.3f s of processors %12.0f points/s %7.0f MiB", figures->seconds,
                    figures->processor_seconds, static_cast<double>(figures->points) / figures->seconds,
                    figures->peak_mebibytes);
        if (before) {
            const double exponent = exponent_between(*before, *figures);
            is_reached = size != sizes.back() || exponent <= most_exponent;
            std::printf("  exponent %.2f%s", exponent, is_reached ? "" : ", MISSED");
        }
        std::printf("\n");
        before = figures;
    }
    return is_reached;
}

/// The lines of docs/gallery/sizes.csv of a method.
void print_rows(const Method& method)
{
    constexpr double most_growth = 13; // in time, where points become ten times as many
    constexpr double most_expected = 30;
    std::string keys = method.table;
    for (std::size_t at = 0; (at = keys.find('"', at)) != keys.npos; at += 2) keys.insert(at, "\"");
    double before = 0;
    for (const std::size_t size : {10'000, 100'000, 1'000'000, 10'000'000}) {
        if (before * most_growth > most_expected) return;
        std::string why;
        const auto figures = figures_of(method, size, why);
        if (!figures) return;
        std::printf("%s,\"%s\",%d,%zu,%.3g,%.2g\n", method.name.c_str(), keys.c_str(), method.dimension, size,
                    figures->processor_seconds, figures->peak_mebibytes * 1.048576e-3);
        std::fflush(stdout);
        before = figures->processor_seconds;
    }
}

}
}

/// --benchmark_filter=REGEX: only methods whose names it finds. --csv: for the manual.
int main(int argc, char** argv)
{
    using namespace poissonlab::bench;
    const std::string key = "--benchmark_filter=";
    std::regex filter{""}; // which all names match
    bool is_csv = false;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option.starts_with(key))
            filter = option.substr(key.size());
        else if (option == "--csv")
            is_csv = true;
        else {
            std::fprintf(stderr, "bench_scale: %s: must be --benchmark_filter=REGEX or --csv\n", argv[i]);
            return 2;
        }
    }
    bool are_reached = true;
    if (is_csv) std::puts("sampler,keys,dimension,points,seconds,gigabytes");
    for (const Method& method : methods) {
        if (!std::regex_search(name_of(method), filter)) continue;
        if (is_csv)
            print_rows(method);
        else
            are_reached = tell_growth(method) && are_reached;
    }
    return are_reached ? 0 : 1;
}
