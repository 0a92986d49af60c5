// A file of a window's points that is larger than memory, written by one process or by several together.
#pragma once

#include "app/commands/tiles/window_points.hpp"
#include "base/crew/crew.hpp"
#include "base/points/placed_file.hpp"
#include "base/regions/plane_region.hpp"

namespace poissonlab {

/// Writes all points. Files with known places are written by all processes of the crew, one piece while the next one is
/// made, and have the same bytes for any number of them; others by the process that leads. `head` lacks the number of
/// points. To be called by all processes, on a file system that they share. Whole or not at all. Throws InputError
/// before any point is made where the disk has no room for them, StorageError. Returns their number, in the process
/// that leads.
/// Names of columns and the system of coordinates are those of the region, if there is one.
std::uint64_t write_window(const std::filesystem::path& path, PointFileHead head, WindowPoints& points, Crew& crew,
                           const PlaneRegion* region);

/// Writes all points, which have classes, in one of the formats of class files. The process that leads writes the file.
std::uint64_t write_class_window(const std::filesystem::path& path, const PointFileHead& head, WindowPoints& points,
                                 Crew& crew, const PlaneRegion* region);

}
