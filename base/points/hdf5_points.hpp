// Points in HDF5, without their numbers: the library makes the file, and says where the numbers go, which PlacedFile
// puts there.
//
// .h5      /points: N x dimension, float64, in chunks of some megabytes, with the attributes `domain` (two numbers),
//          `unit` and `comment`.
// .hdf5    3D: a snapshot as Gadget writes it (Springel, Simulating cosmic structure formation with GADGET-4, MNRAS
//          506, 2021, appendix A): /Header with its attributes, /PartType1/Coordinates (N x 3, float64) and
//          /PartType1/ParticleIDs (uint64, from 1 on); BoxSize is the side, and all mass is BoxSize^3. monofonIC takes
//          Header/BoxSize and the coordinates of it (its GlassFileName).
// .h5part  3D: H5Part, /Step#0/x, y and z, float64, of the unit cube. SPH-EXA takes them (its --glass).
#pragma once

#include "base/points/placed_file.hpp"

namespace poissonlab {

/// True for the three names.
bool is_hdf5_name(const std::filesystem::path& path);

/// True for names of files of particles: .hdf5 and .h5part.
bool is_particle_file(const std::filesystem::path& path);

/// Throws InputError for particles in 2D, and for snapshots of more than 2^32 - 1.
void check_hdf5_head(const std::filesystem::path& path, const PointFileHead& head);

/// Makes the file; its format follows the name of `target`. Throws StorageError, a line about `target`.
void create_hdf5_points(const std::filesystem::path& file, const std::filesystem::path& target,
                        const PointFileHead& head);

/// The places of the numbers in a file that create_hdf5_points() has made. Throws StorageError.
std::vector<PlacedColumn> hdf5_columns(const std::filesystem::path& file, const std::filesystem::path& target,
                                       const PointFileHead& head);

}
