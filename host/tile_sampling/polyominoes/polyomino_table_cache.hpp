// Tables of polyominoes that were built before: building takes seconds, reading a file milliseconds.
#pragma once

#include "results/records/sample_records.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

/// A table and what getting it took.
struct CachedPolyominoTable
{
    PolyominoTable table;
    bool cached = false;        ///< read, not built
    double waiting_seconds = 0; ///< for another process that was building it
};

/// The name of a table's file: there is one for each polyomino and version of the code.
std::string polyomino_table_name(Polyomino shape);

/// The table from `folder`, or built and put there. A file that is damaged is replaced; where nothing can be written,
/// the table is not kept. An empty folder: always built. `on_step` is told of waiting and of the steps of building;
/// what it throws ends that.
CachedPolyominoTable cached_polyomino_table(Polyomino shape, const std::filesystem::path& folder,
                                            const std::function<void(const std::string& what)>& on_step = {});

}
