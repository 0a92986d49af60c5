// Pieces of work that may fail, done on all processor cores at once.
//
// Where a piece of tbb::parallel_invoke() or tbb::parallel_for() throws, oneTBB cancels the others together with all
// loops that are nested in them: these loops return without a word and without having run, and what they should have
// filled is read as if it were whole. These functions let every piece come to its end, and then throw the first failure
// in the order of the pieces.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <functional>
#include <vector>

namespace poissonlab {

/// Calls work(i) for every i below `count`, on all cores. Throws what the first of them threw, once all have ended.
template <typename Work>
void for_all_side_by_side(std::size_t count, const Work& work)
{
    std::vector<std::exception_ptr> failures(count);
    const auto guarded = [&](std::size_t i) {
        try {
            work(i);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    };
    tbb::parallel_for(std::size_t{0}, count, guarded, tbb::simple_partitioner{}); // pieces are long: a task each
    const auto failure = std::ranges::find_if(failures, [](const auto& one) { return one != nullptr; });
    if (failure != failures.end()) std::rethrow_exception(*failure);
}

/// Calls work(element) for every element of a random access range, on all cores. Throws as for_all_side_by_side().
template <typename Range, typename Work>
void for_each_side_by_side(Range& range, const Work& work)
{
    for_all_side_by_side(range.size(), [&](std::size_t i) { work(range[i]); });
}

/// Calls functions without arguments at once. Throws as for_all_side_by_side().
template <typename... Works>
void do_side_by_side(const Works&... works)
{
    const std::array<std::function<void()>, sizeof...(works)> all{std::ref(works)...};
    for_each_side_by_side(all, [](const auto& work) { work(); });
}

}
