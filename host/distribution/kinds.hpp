// All kinds of work that are described by their keys.
#pragma once

#include "host/distribution/kind.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// In the order in which messages and the documentation list them.
const std::vector<Kind>& all_kinds();

/// The kind of a table with this word; null where there is none.
const Kind* find_kind(const std::string& table, const std::string& word);

// Each is in a file of the folder runs.
Kind warp_kind();
Kind object_kind();
Kind self_similar_kind();
Kind rank_kind();
Kind stippling_kind();
Kind hatching_kind();
Kind icon_kind();
Kind instance_kind();

}
