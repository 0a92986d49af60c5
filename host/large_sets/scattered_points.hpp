// A file of points that processes hold by their places, written in the order of their numbers.
#pragma once

#include "base/points/placed_file.hpp"
#include "host/large_sets/slab_points.hpp"

#include <filesystem>

namespace poissonlab {

/// Writes the points, some hundred thousand of them at a time: files with known places by all processes together,
/// others by the one that leads. The file is there whole or not at all. To be called by all processes; false where one
/// failed. Throws StorageError in the process that leads.
bool write_scattered_points(const std::filesystem::path& path, const PointFileHead& head, const SlabPoints& points,
                            Crew& crew);

/// The bytes that a point takes while this is done, in the process that has it.
constexpr std::uint64_t scattered_bytes_per_point = 16;

}
