// Building Poisson tile sets, all stages and the certificate included, and kernels against the sequential
// reference.
//
// The reference takes minutes for a whole set, so the two fill the same 128 of the tori of a set with 8
// colours: those of tiles, which are 95 of 100.
#include "host/tile_construction/tile_ranking.hpp"
#include "host/tile_sampling/tile_set_cache.hpp"
#include "tests/bench/ratio_reporter.hpp"
#include "tests/support/small_tile_sets.hpp"

#include <fmt/format.h>

namespace poissonlab::bench {
namespace {

constexpr std::uint32_t threads = 2;
constexpr std::size_t compared_tori = 128;

Device& device()
{
    static Device opened = Device::open({}, threads);
    return opened;
}

enum Set
{
    corner_4,
    corner_8,
    edge_2,
    sphere_2,
    chain_3,
    chain_4,
    chain_8,
    even_3,
    even_4,
    together_4,
    even_strips_4
};

PoissonTileParameters with_chains(PoissonTileParameters parameters, std::uint32_t equal_moments = 0)
{
    set_border(parameters, TileBorder::chain, {}, {}, equal_moments);
    return parameters;
}

PoissonTileParameters with_strips_together(PoissonTileParameters parameters, std::uint32_t equal_moments)
{
    set_border(parameters, TileBorder::strip, 20, {}, equal_moments);
    return parameters;
}

PoissonTileParameters parameters_of(std::int64_t set)
{
    const auto made = [](PoissonTileKind kind, int dimension, std::uint32_t colors, std::uint32_t points) {
        return with_repulsion(tile_set_parameters(kind, dimension, colors, points, 0.75));
    };
    switch (set) {
    case corner_4:
        return made(PoissonTileKind::corner, 2, 4, 64);
    case corner_8:
        return made(PoissonTileKind::corner, 2, 8, 64);
    case edge_2:
        return made(PoissonTileKind::edge, 2, 2, 64);
    case chain_3:
        return with_chains(made(PoissonTileKind::corner, 2, 3, 32));
    case even_3:
        return with_chains(made(PoissonTileKind::corner, 2, 3, 32), 2);
    case even_4:
        return with_chains(made(PoissonTileKind::corner, 2, 4, 32), 2);
    case together_4:
        return with_strips_together(made(PoissonTileKind::corner, 2, 4, 64), 0);
    case even_strips_4:
        return with_strips_together(made(PoissonTileKind::corner, 2, 4, 64), 2);
    case chain_4:
        return with_chains(made(PoissonTileKind::corner, 2, 4, 32));
    case chain_8:
        return with_chains(made(PoissonTileKind::corner, 2, 8, 32));
    default:
        return made(PoissonTileKind::corner, 3, 2, 128);
    }
}

void build(benchmark::State& state)
{
    const PoissonTileParameters parameters = parameters_of(state.range(0));
    PoissonTileParameters small = parameters; // builds the kernels
    small.colors = 1;
    small.tiles = 1;
    const DeviceProvider provider = []() -> Device& { return device(); };
    build_tile_set(small, Engine::opencl, provider);
    for (auto _ : state) benchmark::DoNotOptimize(build_tile_set(parameters, Engine::opencl, provider));
    state.SetLabel(kind_name(parameters) + (parameters.border == TileBorder::chain ? " with chains, " : ", ") +
                   (parameters.equal_moments > 0 ? "equal moments, " : "") + std::to_string(parameters.tiles) +
                   " tiles");
}

/// The ranks of 256 tiles with chains.
void rank(benchmark::State& state)
{
    PoissonTileParameters parameters = with_chains(with_repulsion(
        tile_set_parameters(PoissonTileKind::corner, 2, 4, static_cast<std::uint32_t>(state.range(0)), 0.75)));
    const PoissonTileSet set = build_tile_set(parameters, Engine::opencl, []() -> Device& { return device(); }).set;
    for (auto _ : state) benchmark::DoNotOptimize(rank_points(set));
}

/// Some of the tori that tiles with 8 colours are taken from.
struct Tori
{
    FillStage stage;
    std::vector<FillProblem> problems;
};

/// A filler that notes the first tiles' tori.
class NotingFiller final : public TileFiller
{
public:
    explicit NotingFiller(Tori& tori)
        : tori_(tori), filler_(make_tile_filler(fill_settings(parameters_of(corner_8)), device()))
    {}

    std::vector<FilledTorus> fill(const FillStage& stage, std::span<const FillProblem> problems,
                                  std::uint32_t attempt) override
    {
        if (stage.surroundings.cells != 0 && tori_.problems.empty()) {
            tori_.stage = stage;
            tori_.problems.assign(problems.begin(), problems.begin() + compared_tori);
        }
        return filler_->fill(stage, problems, attempt);
    }

private:
    Tori& tori_;
    std::unique_ptr<TileFiller> filler_;
};

const Tori& tori()
{
    static const Tori noted = [] {
        Tori result;
        NotingFiller filler(result);
        construct_tile_set(parameters_of(corner_8), filler);
        return result;
    }();
    return noted;
}

void fill(benchmark::State& state, TileFiller& filler)
{
    filler.fill(tori().stage, tori().problems, 0);
    for (auto _ : state) benchmark::DoNotOptimize(filler.fill(tori().stage, tori().problems, 0));
}

void fill_by_kernels(benchmark::State& state)
{
    fill(state, *make_tile_filler(fill_settings(parameters_of(corner_8)), device()));
}

void fill_by_reference(benchmark::State& state)
{
    fill(state, *reference::make_tile_filler(fill_settings(parameters_of(corner_8))));
}

void add(const char* name, void (*function)(benchmark::State&), std::int64_t argument, int repetitions)
{
    benchmark::RegisterBenchmark(name, caught(function))
        ->Arg(argument)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->Iterations(1)
        ->Repetitions(repetitions);
}

}
}

int main(int argc, char** argv)
{
    using namespace poissonlab::bench;
    add("fill_by_reference", fill_by_reference, corner_8, 3);
    add("fill_by_kernels", fill_by_kernels, corner_8, 5);
    add("build", build, corner_4, 5);
    add("build", build, corner_8, 3);
    add("build", build, edge_2, 3);
    add("build", build, sphere_2, 1);
    add("build", build, chain_3, 5);
    add("build", build, even_3, 5);
    add("build", build, chain_4, 5);
    add("build", build, even_4, 5);
    add("build", build, together_4, 5);
    add("build", build, even_strips_4, 5);
    add("build", build, chain_8, 3);
    add("rank", rank, 32, 5);
    add("rank", rank, 64, 5);
    return run_benchmarks(
        argc, argv,
        {{"corner set of 8 colours: sequential reference / kernels", "fill_by_reference/1", "fill_by_kernels/1", 6},
         {"chains, C = 3: without / with equal second moments", fmt::format("build/{}", +chain_3),
          fmt::format("build/{}", +even_3), 0.5},
         {"chains, C = 4: without / with equal second moments", fmt::format("build/{}", +chain_4),
          fmt::format("build/{}", +even_4), 0.5},
         {"strips together, C = 4: without / with equal second moments", fmt::format("build/{}", +together_4),
          fmt::format("build/{}", +even_strips_4), 0.5}},
        {{"strips, C = 4: ms", fmt::format("build/{}", +corner_4), 315},
         {"strips, C = 8: ms", fmt::format("build/{}", +corner_8), 3000},
         {"chains, C = 4: ms", fmt::format("build/{}", +chain_4), 1500},
         {"chains, C = 8: ms", fmt::format("build/{}", +chain_8), 20'000},
         {"ranks of C = 4, N = 64: ms", "rank/64", 1000}});
}
