// The functions by which this room calls the module with HDF5, the library of files of particles: see hdf5_points.hpp
// and hdf5_reading.hpp for what the functions do.
#pragma once

#include "base/points/hdf5_reading.hpp"
#include "base/points/placed_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

/// Takes the coordinates of whole points as they are stored, of which `first` are before.
using StoredPieceSink = std::function<void(std::uint64_t first, std::span<const double> coordinates)>;

/// The functions of the module, each as that of its longer name in the room.
struct Hdf5Files
{
    void (*create)(const std::filesystem::path& file, const std::filesystem::path& target, const PointFileHead& head);
    std::vector<PlacedColumn> (*columns)(const std::filesystem::path& file, const std::filesystem::path& target,
                                         const PointFileHead& head);
    Hdf5Head (*head)(const std::filesystem::path& path, const PointReading& how);
    void (*stream)(const std::filesystem::path& path, const PointReading& how, const StoredPieceSink& sink);
    std::vector<std::filesystem::path> (*parts)(const std::filesystem::path& path);
};

/// The function of the module that returns these.
using Hdf5FilesFunction = const Hdf5Files* (*)();
inline constexpr const char* hdf5_files_function = "poissonlab_hdf5_files";

// The module is made of these.
void write_hdf5_file(const std::filesystem::path& file, const std::filesystem::path& target, const PointFileHead& head);
std::vector<PlacedColumn> columns_of_hdf5_file(const std::filesystem::path& file, const std::filesystem::path& target,
                                               const PointFileHead& head);
Hdf5Head head_of_hdf5_file(const std::filesystem::path& path, const PointReading& how);
void stream_hdf5_file(const std::filesystem::path& path, const PointReading& how, const StoredPieceSink& sink);
std::vector<std::filesystem::path> parts_of_hdf5_file(const std::filesystem::path& path);

}
