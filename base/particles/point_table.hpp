// A table of coordinates in HDF5, read in pieces.
#pragma once

#include "base/particles/hdf5_objects.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// An open table of points.
struct PointTable
{
    Hdf5Object file, set;
    hsize_t rows = 0;
    std::size_t columns = 0;
    double rounding = 0; ///< half the relative distance between neighbours of its numbers
};

/// Opens a table of points; returns nothing where the file has no such table, or one without rows. Throws InputError
/// without the file's name for a table that holds no points, and for one that this HDF5 cannot read: by its
/// compression, or because files are missing that it is put together of.
std::optional<PointTable> open_point_table(const std::filesystem::path& path, const std::string& name);

void read_rows(const PointTable& table, hsize_t first, hsize_t rows, std::vector<double>& numbers);

/// Do all points of these files have the same coordinate along an axis?
bool has_one_number(const std::vector<std::filesystem::path>& files, const std::string& table, std::size_t axis);

}
