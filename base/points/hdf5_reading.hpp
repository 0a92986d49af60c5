// Points from HDF5: the table /points of .h5 files, and snapshots of simulations as Gadget (2 to 4), SWIFT and their
// kin have them: /PartType0 to /PartType6, the coordinates of each type of particles.
//
// A snapshot is held against its own header: the numbers of particles (NumPart_ThisFile, NumPart_Total and its high
// word), and the side of the box (BoxSize of /Header, /Parameters or /Cosmology, one number or one for each axis). It
// may have several files (NumFilesPerSnapshot), NAME.0.hdf5 and so on, which are read together.
#pragma once

#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace poissonlab {

/// The head of an HDF5 file tells the number, dimension and domain of its points before they are read.
struct Hdf5Head
{
    std::uint64_t points = 0;
    int dimension = 2;
    PointDomain domain{};            ///< as asked for, or as the file declares it
    double rounding = 0;             ///< half the relative distance between neighbours of the stored numbers
    std::vector<std::string> told{}; ///< what readers must know, sentences without the file's name
};

/// True for a file that is stored and begins as HDF5 does.
bool is_hdf5_file(const std::filesystem::path& path);

/// Throws InputError for files that hold no points in 2D or 3D, or not those that their header says.
Hdf5Head head_of_hdf5_points(const std::filesystem::path& path, const PointReading& how);

/// Reads the set of a file in pieces, in unit coordinates. Throws InputError, also where some lie outside of the range.
void stream_hdf5_points(const std::filesystem::path& path, const PointReading& how, const PieceSink& sink);

/// The whole set; `domain` becomes that of its coordinates.
PointSet read_hdf5_points(const std::filesystem::path& path, const PointReading& how, PointDomain& domain);

/// All files of the snapshot, or the file itself.
std::vector<std::filesystem::path> parts_of_hdf5_points(const std::filesystem::path& path);

}
