// A point file whose numbers have known places, written piece by piece by one process or by several together.
#pragma once

#include "base/crew/crew.hpp"
#include "base/points/placed_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace poissonlab {

/// Makes the coordinates of a piece, instead of those that are in `coordinates`.
using MakePiece = std::function<void(std::uint32_t piece, std::vector<double>& coordinates)>;

/// A schedule of jobs that wait for none, one for each number below `count`.
Schedule one_job_each(std::uint32_t count);

/// Writes a file with known places. `before` has the number of points before each piece, and at the end that of all,
/// which is that of `head`. Each piece is made by the process that happens to be free, and written while the next one
/// is made; bytes do not depend on the processes. To be called by all of them, on a file system that they share. The
/// file is there whole or not at all. Throws StorageError in the process that leads; the others return.
void write_placed_pieces(const std::filesystem::path& path, const PointFileHead& head,
                         const std::vector<std::uint64_t>& before, const MakePiece& make, Crew& crew);

}
