// The figures that tiles with chains are held to: lattice peaks up to the first ring of the spectrum, beside those of
// strips, and what equal moments leave of the power between the peaks. They do not depend on the machine.
#include "analysis/measures/hyperuniformity.hpp"
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/mean_tile.hpp"
#include "tests/support/small_tile_sets.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab::bench {
namespace {

constexpr std::uint32_t tilings = 10;

Device& device()
{
    static Device opened = Device::open();
    return opened;
}

PoissonTileParameters parameters_of(TileBorder border, std::uint32_t colors, std::uint32_t points)
{
    PoissonTileParameters p = with_repulsion(tile_set_parameters(PoissonTileKind::corner, 2, colors, points, 0.75));
    set_border(p, border);
    return p;
}

/// Means over so many tile sets, each of ten tilings of `side` x `side` tiles: the height of peaks up to the first
/// ring, their excess, in parts in a hundred of the power, and the power of the mean tile beyond the ring, where peaks
/// are `side` squared times as high.
void measure(benchmark::State& state, const PoissonTileParameters& parameters, std::uint32_t side, int sets)
{
    double peak = 0, excess = 0, beyond = 0;
    for (auto _ : state)
        for (int seed = 1; seed <= sets; ++seed) {
            PoissonTileParameters p = parameters;
            p.seed = static_cast<std::uint64_t>(seed);
            const PoissonTileSet set = build_tile_set(p, Engine::opencl, []() -> Device& { return device(); }).set;
            const double root = std::sqrt(p.points_per_tile);
            beyond += power_of_mean_tile(set, 1.4 * root, 2 * root) / sets;
            SpectrumEstimate spectrum(2, spectrum_size(std::size_t{side} * side * p.points_per_tile, 2), true);
            for (std::uint32_t tiling = 1; tiling <= tilings; ++tiling)
                spectrum.add(reference::torus_points(set, tiling, side));
            const auto peaks = near_lattice_peaks(spectrum.mean(), static_cast<int>(side)).value();
            peak += peaks.mean_ratio / sets;
            excess += 100 * peaks.excess_share / sets;
        }
    state.counters["mean_peak"] = peak;
    state.counters["excess"] = excess;
    state.counters["beyond"] = beyond;
}

/// The mean power at frequencies of a range, in cycles a tile, without those of the lattice.
double power_between(const Spectrum& spectrum, int side, double low, double high)
{
    double sum = 0;
    int count = 0;
    const int half = spectrum.size / 2;
    for (int v = -half; v < half; ++v)
        for (int u = -half; u < half; ++u) {
            const double cycles = std::hypot(u, v) / side;
            if (cycles < low || cycles > high || (u % side == 0 && v % side == 0)) continue;
            sum += spectrum.at(u, v);
            ++count;
        }
    return sum / count;
}

/// Measures the power that tilings of 48 x 48 tiles have between the peaks, over tile sets of seeds that nothing was
/// chosen by: power at a twelfth of the tiles' frequency, in millionths, at a quarter, in ten thousandths, and from 0.6
/// to 1.5 of it; and the exponent below 0.4.
void measure_evenness(benchmark::State& state, const PoissonTileParameters& parameters)
{
    constexpr std::uint32_t side = 48;
    constexpr int sets = 3, frequencies = 160;
    constexpr std::uint64_t first_seed = 101;
    double twelfth = 0, quarter = 0, middle = 0, exponent = 0;
    for (auto _ : state)
        for (std::uint64_t seed = first_seed; seed < first_seed + sets; ++seed) {
            PoissonTileParameters p = parameters;
            p.seed = seed;
            const PoissonTileSet set = build_tile_set(p, Engine::opencl, []() -> Device& { return device(); }).set;
            SpectrumEstimate estimate(2, frequencies, true);
            for (std::uint32_t tiling = 1; tiling <= tilings; ++tiling)
                estimate.add(reference::torus_points(set, tiling, side));
            const Spectrum mean = estimate.mean();
            constexpr double near = 0.25 / side; // the ring of integers that is nearest
            twelfth += 1e6 * power_between(mean, side, 1.0 / 12 - near, 1.0 / 12 + near) / sets;
            quarter += 1e4 * power_between(mean, side, 1.0 / 4 - near, 1.0 / 4 + near) / sets;
            middle += power_between(mean, side, 0.6, 1.5) / sets;
            const auto range = hyperuniform_range(std::size_t{side} * side * p.points_per_tile, 2, side);
            exponent +=
                hyperuniformity_exponent(power_shells(mean, range), tilings, zero_power(mean)).value().value / sets;
        }
    state.counters["twelfth"] = twelfth;
    state.counters["quarter"] = quarter;
    state.counters["middle"] = middle;
    state.counters["exponent"] = exponent;
    state.counters["short_of_six"] = 6 - exponent;
}

void add_evenness(const char* name, std::uint32_t equal_moments)
{
    PoissonTileParameters p = parameters_of(TileBorder::chain, 3, 32);
    p.equal_moments = equal_moments;
    benchmark::RegisterBenchmark(name, caught([p](benchmark::State& state) { measure_evenness(state, p); }))
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
}

/// Measures all points of tilings whose points have classes, and those of each class: as measure() and
/// measure_evenness() do, the height of lattice peaks, their excess, and power at a quarter of the tiles' frequency,
/// in ten thousandths.
void measure_classes(benchmark::State& state, const PoissonTileParameters& parameters)
{
    constexpr std::uint32_t side = 16;
    constexpr int sets = 6;
    const std::size_t classes = parameters.classes.count();
    std::vector<std::array<double, 3>> sums(classes + 1); // the last one of all points
    for (auto _ : state)
        for (int seed = 1; seed <= sets; ++seed) {
            PoissonTileParameters p = parameters;
            p.seed = static_cast<std::uint64_t>(seed);
            const PoissonTileSet set = build_tile_set(p, Engine::opencl, []() -> Device& { return device(); }).set;
            for (std::uint32_t of = 0; of <= classes; ++of) {
                const PoissonTileSet part = of < classes ? class_subset(set, of) : set;
                const std::uint32_t points = part.parameters.points_per_tile;
                SpectrumEstimate estimate(2, spectrum_size(std::size_t{side} * side * points, 2), true);
                for (std::uint32_t tiling = 1; tiling <= tilings; ++tiling)
                    estimate.add(reference::torus_points(part, tiling, side));
                const Spectrum mean = estimate.mean();
                const auto peaks = near_lattice_peaks(mean, static_cast<int>(side)).value();
                sums[of][0] += peaks.mean_ratio / sets;
                sums[of][1] += 100 * peaks.excess_share / sets;
                sums[of][2] += 1e4 * power_between(mean, side, 0.22, 0.28) / sets;
            }
        }
    for (std::size_t of = 0; of <= classes; ++of) {
        const std::string name = of < classes ? std::to_string(of) : "all";
        state.counters["mean_peak_" + name] = sums[of][0];
        state.counters["excess_" + name] = sums[of][1];
        state.counters["quarter_" + name] = sums[of][2];
    }
}

void add_classes(const std::string& name, std::vector<std::uint32_t> points, std::uint32_t joint_iterations,
                 std::uint32_t equal_moments)
{
    PoissonTileParameters p = tile_set_parameters(PoissonTileKind::corner, 2, 3, 0, 0);
    set_border(p, TileBorder::strip, joint_iterations, {}, equal_moments);
    set_classes(p, classes_of_radius(std::move(points), 0.7, 2));
    benchmark::RegisterBenchmark(name, caught([p](benchmark::State& state) { measure_classes(state, p); }))
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
}

void add(const char* name, TileBorder border, std::uint32_t colors, std::uint32_t points, std::uint32_t side,
         std::optional<std::uint32_t> joint_iterations = {}, int sets = 3, std::uint32_t equal_moments = 0)
{
    PoissonTileParameters p = parameters_of(border, colors, points);
    set_border(p, border, joint_iterations, {}, equal_moments);
    benchmark::RegisterBenchmark(name,
                                 caught([p, side, sets](benchmark::State& state) { measure(state, p, side, sets); }))
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
}

}
}

int main(int argc, char** argv)
{
    using namespace poissonlab;
    using namespace poissonlab::bench;
    add("strips_3", TileBorder::strip, 3, 32, 8);
    add("strips_together_3", TileBorder::strip, 3, 32, 8, 20);
    add("chains_3", TileBorder::chain, 3, 32, 8, {}, 12); // single sets of 81 tiles differ by a factor of two
    add("chains_6", TileBorder::chain, 6, 32, 8);
    add("strips_4", TileBorder::strip, 4, 64, 16);
    add("chains_4", TileBorder::chain, 4, 64, 16, 33);
    add("even_3", TileBorder::chain, 3, 32, 8, {}, 12, 2);
    add_evenness("moments_0", 0);
    add_evenness("moments_1", 1);
    add_evenness("moments_2", 2);
    for (const auto& [name, points] : {std::pair{"classes_8_16_40", std::vector<std::uint32_t>{8, 16, 40}},
                                       std::pair{"classes_32_96", std::vector<std::uint32_t>{32, 96}}}) {
        add_classes(fmt::format("{}_strips", name), points, 0, 0);
        add_classes(fmt::format("{}_together", name), points, 20, 0);
        add_classes(fmt::format("{}_moments_1", name), points, 20, 1);
    }
    add_classes("classes_32_96_moments_2", {32, 96}, 20, 2);
    return run_benchmarks(
        argc, argv,
        {{"C = 4, N = 64: excess share of strips / of chains", "strips_4/", "chains_4/", 30, "excess"},
         {"C = 3: mean peak of strips / of strips relaxed together", "strips_3/", "strips_together_3/", 2, "mean_peak"},
         {"C = 3, chains: mean peak without / with equal second moments", "chains_3/", "even_3/", 1, "mean_peak"},
         {"C = 3, chains: peaks from 1.4 to 2 sqrt N, without / with equal second moments", "chains_3/", "even_3/", 1,
          "beyond"},
         {"equal second moments: power from 0.6 to 1.5 of the tiles' frequency, without / with", "moments_0/",
          "moments_2/", 1 / 1.2, "middle"}},
        {{"C = 3, chains: mean peak", "chains_3/", 1.8, "mean_peak"},
         {"C = 3, chains: excess share, %", "chains_3/", 0.6, "excess"},
         {"C = 6, chains: mean peak", "chains_6/", 1.1, "mean_peak"},
         {"equal second moments: power at a twelfth of it, in millionths", "moments_2/", 1, "twelfth"},
         {"equal second moments: power at a quarter of it, in ten thousandths", "moments_2/", 2, "quarter"},
         {"equal second moments: exponent below 0.4 of it, short of 6 by", "moments_2/", 0.5, "short_of_six"}});
}
