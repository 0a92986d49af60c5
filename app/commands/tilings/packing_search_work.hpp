// The options of searches for packings, and what is said of a search while it goes on.
#pragma once

#include "app/commands/kind_options.hpp"
#include "tiles/packing/packing_search.hpp"

namespace poissonlab {

struct SearchOptions
{
    bool all = false;
    bool count = false;
    std::filesystem::path checkpoint; ///< empty: none
    std::string shard;                ///< "i/n"; empty: all
    int threads = 0;                  ///< 0: all

    std::vector<Option> options();
};

/// Searches, with a line of progress now and then on standard error, unless the command is quiet. Throws InputError
/// where a search for one packing finds none in the whole tree, and what search_packings() throws; a shard may have
/// none.
FoundPackings found_packings(const PackingProblem& problem, const SearchOptions& search, const KindOptions& options);

}
