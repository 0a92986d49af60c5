// The table of Penrose points that was built before: building takes seconds, reading a file does not.
#pragma once

#include "host/tile_sampling/built_once.hpp"
#include "host/tile_sampling/penrose/penrose_table.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

/// The name of the table's file: there is one for each version of the code.
std::string penrose_table_name();

/// The table from `folder`, or built and put there: see built_once(). An empty folder: always built. `on_step` is told
/// of waiting and of the steps of building; what it throws ends that.
BuiltOnce<PenroseTable> cached_penrose_table(const std::filesystem::path& folder,
                                             const std::function<void(const std::string& what)>& on_step = {});

}
