// Benchmarks whose errors are caught: BENCHMARK and its kin of Google Benchmark, but for bodies that end by an
// exception. These end with an error of their own, with their name, and those after them still run.
#pragma once

#include <benchmark/benchmark.h>

#include <exception>

namespace poissonlab::bench {

/// The body of a benchmark, whose exceptions become its error.
template <class Body>
auto caught(Body body)
{
    return [body](benchmark::State& state) {
        try {
            body(state);
        } catch (const std::exception& error) {
            state.SkipWithError(error.what());
        }
    };
}

}

#undef BENCHMARK
#undef BENCHMARK_TEMPLATE
#undef BENCHMARK_CAPTURE

#define BENCHMARK(body)                                                                                                \
    BENCHMARK_PRIVATE_DECLARE(_benchmark_) = ::benchmark::RegisterBenchmark(#body, ::poissonlab::bench::caught(body))

#define BENCHMARK_TEMPLATE(body, ...)                                                                                  \
    BENCHMARK_PRIVATE_DECLARE(_benchmark_) =                                                                           \
        ::benchmark::RegisterBenchmark(#body "<" #__VA_ARGS__ ">", ::poissonlab::bench::caught(body<__VA_ARGS__>))

#define BENCHMARK_CAPTURE(body, name, ...)                                                                             \
    BENCHMARK_PRIVATE_DECLARE(_benchmark_) = ::benchmark::RegisterBenchmark(                                           \
        #body "/" #name, ::poissonlab::bench::caught([](::benchmark::State& state) { body(state, __VA_ARGS__); }))
