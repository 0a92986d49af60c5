// Exact covers: choices of rows of a matrix of zeros and ones that have exactly one 1 in each column.
//
// Knuth, Dancing links, 2000: the column with the fewest rows left is covered first. Rows are tried in random order,
// and a search that takes too many steps begins anew with another one, as most of them end soon or never.
#pragma once

#include "base/random/random.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace poissonlab {

struct CoverProblem
{
    std::uint32_t columns = 0;
    std::vector<std::vector<std::uint32_t>> rows; ///< the columns in which each row has a 1

    /// Steps (rows that are tried) after which a search begins anew, and searches after which it ends without a cover.
    std::uint64_t steps = 1'000'000;
    std::uint32_t searches = 1;
};

/// A random exact cover: the numbers of its rows, ascending. Nothing if none was found, which proves only with one
/// search that ended by itself that there is none. The attempt of the stream is the search. `on_search`, which may be
/// empty, is told of each search before it begins; what it throws ends the work.
std::optional<std::vector<std::uint32_t>> exact_cover(const CoverProblem& problem, std::uint64_t seed, Purpose purpose,
                                                      std::uint32_t realization,
                                                      const std::function<void(std::uint32_t)>& on_search = {});

/// All exact covers, each ascending, in the order of a search without chance.
std::vector<std::vector<std::uint32_t>> all_exact_covers(const CoverProblem& problem);

}
