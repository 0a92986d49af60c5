// The figures that tiles with chains are held to: lattice peaks up to the first ring of the spectrum, beside those of
// strips. They do not depend on the machine.
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "host/tile_points/tile_points.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/small_tile_sets.hpp"

#include <cmath>

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

/// Means over so many tile sets, each of ten tilings of `side` x `side` tiles. The unit of excess is a part in a
/// hundred of the power.
void measure(benchmark::State& state, const PoissonTileParameters& parameters, std::uint32_t side, int sets)
{
    double peak = 0, excess = 0;
    for (auto _ : state)
        for (int seed = 1; seed <= sets; ++seed) {
            PoissonTileParameters p = parameters;
            p.seed = static_cast<std::uint64_t>(seed);
            const PoissonTileSet set = build_tile_set(p, Engine::opencl, []() -> Device& { return device(); }).set;
            SpectrumEstimate spectrum(2, spectrum_size(std::size_t{side} * side * p.points_per_tile, 2), true);
            for (std::uint32_t tiling = 1; tiling <= tilings; ++tiling)
                spectrum.add(reference::torus_points(set, tiling, side));
            const auto peaks = near_lattice_peaks(spectrum.mean(), static_cast<int>(side)).value();
            peak += peaks.mean_ratio / sets;
            excess += 100 * peaks.excess_share / sets;
        }
    state.counters["mean_peak"] = peak;
    state.counters["excess"] = excess;
}

void add(const char* name, TileBorder border, std::uint32_t colors, std::uint32_t points, std::uint32_t side,
         std::optional<std::uint32_t> joint_iterations = {}, int sets = 3)
{
    PoissonTileParameters p = parameters_of(border, colors, points);
    if (joint_iterations) set_border(p, border, joint_iterations);
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
    return run_benchmarks(
        argc, argv,
        {{"C = 4, N = 64: excess share of strips / of chains", "strips_4/", "chains_4/", 30, "excess"},
         {"C = 3: mean peak of strips / of strips relaxed together", "strips_3/", "strips_together_3/", 2,
          "mean_peak"}},
        {{"C = 3, chains: mean peak", "chains_3/", 1.8, "mean_peak"},
         {"C = 3, chains: excess share, %", "chains_3/", 0.6, "excess"},
         {"C = 6, chains: mean peak", "chains_6/", 1.1, "mean_peak"}});
}
