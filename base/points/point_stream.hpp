// Point files that need not fit in memory, read in pieces: text, NumPy and HDF5, of one set each.
#pragma once

#include "base/points/point_file.hpp"
#include "base/points/point_strips.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>

namespace poissonlab {

/// True for a file that can be read in pieces: a lasting one of these formats with one set.
bool can_be_streamed(const std::filesystem::path& path);

/// The size of the one set of a file, as its head has it.
struct KnownShape
{
    std::uint64_t points = 0;
    int dimension = 2;
};

/// The shape that the head of a NumPy or HDF5 file tells; text has none.
std::optional<KnownShape> known_shape(const std::filesystem::path& path, const PointReading& how = {});

/// About as many points, or more, as a file that can be read in pieces has; exactly as many for NumPy and HDF5.
std::uint64_t points_at_most(const std::filesystem::path& path, const PointReading& how = {});

/// Reads the file into strips, in a folder that is there and as read_points() would read it, and tells of all
/// coordinates in their order. Throws InputError where it holds several sets, or points of the plane with another
/// coordinate; StorageError.
PointStrips read_into_strips(const std::filesystem::path& path, const PointReading& how,
                             const std::filesystem::path& folder,
                             const std::function<void(std::span<const double> coordinates)>& told);

}
