// Textures of one exemplar from the best to the worst, where they were compared with it.
#pragma once

#include "reports/pages/page_parts.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// The table, `places` being those of textures in the run's list: heads, rows; false unless two textures or more have
/// all distances from their exemplar. `anchor` is a prefix, to which a texture's place + 1 is added.
PageData texture_ranking(const ReportRun& run, const std::vector<std::size_t>& places, const std::string& anchor);

}
