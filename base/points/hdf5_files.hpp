// The functions by which this room calls the module with HDF5, the library of files of particles: see hdf5_points.hpp
// and hdf5_reading.hpp for what the functions do.
#pragma once

#include "base/points/placed_file.hpp"
#include "base/points/point_file_formats.hpp"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace poissonlab {

/// The functions of the module, each as that of its longer name in the room.
struct Hdf5Files
{
    void (*create)(const std::filesystem::path& file, const std::filesystem::path& target, const PointFileHead& head);
    std::vector<PlacedColumn> (*columns)(const std::filesystem::path& file, const std::filesystem::path& target,
                                         const PointFileHead& head);
    void (*stream)(const std::filesystem::path& path, std::optional<CoordinateRange> range, const PieceSink& sink);
    std::pair<std::uint64_t, int> (*size)(const std::filesystem::path& path);
};

/// The function of the module that returns these.
using Hdf5FilesFunction = const Hdf5Files* (*)();
inline constexpr const char* hdf5_files_function = "poissonlab_hdf5_files";

// The module is made of these.
void write_hdf5_file(const std::filesystem::path& file, const std::filesystem::path& target, const PointFileHead& head);
std::vector<PlacedColumn> columns_of_hdf5_file(const std::filesystem::path& file, const std::filesystem::path& target,
                                               const PointFileHead& head);
void stream_hdf5_file(const std::filesystem::path& path, std::optional<CoordinateRange> range, const PieceSink& sink);
std::pair<std::uint64_t, int> size_of_hdf5_file(const std::filesystem::path& path);

}
