// Tables of polyominoes that were built before: building takes seconds, reading a file milliseconds.
#pragma once

#include "host/tile_sampling/built_once.hpp"
#include "results/records/sample_records.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

/// The name of a table's file: there is one for each polyomino and version of the code.
std::string polyomino_table_name(Polyomino shape);

/// The table from `folder`, or built and put there: see built_once(). An empty folder: always built. `on_step` is told
/// of waiting and of the steps of building; what it throws ends that.
BuiltOnce<PolyominoTable> cached_polyomino_table(Polyomino shape, const std::filesystem::path& folder,
                                                 const std::function<void(const std::string& what)>& on_step = {});

}
