// Points from HDF5: the table /points of .h5 files, and the coordinates of snapshots as Gadget has them
// (/PartType1/Coordinates; see hdf5_points.hpp).
#pragma once

#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"

#include <filesystem>
#include <optional>

namespace poissonlab {

/// Reads the set of a file in pieces, in unit coordinates. `range` empty: the attribute `domain`, or BoxSize, or [0,
/// 1). Throws InputError for files that hold no points in 2D or 3D, or some outside of the range.
void stream_hdf5_points(const std::filesystem::path& path, std::optional<CoordinateRange> range, const PieceSink& sink);

/// The whole set.
PointSet read_hdf5_points(const std::filesystem::path& path, std::optional<CoordinateRange> range);

/// The number of points, and of coordinates of each.
std::pair<std::uint64_t, int> size_of_hdf5_points(const std::filesystem::path& path);

}
