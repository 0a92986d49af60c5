// Points as particles of simulations: HDF5 files that programs for cosmology and hydrodynamics read as a glass.
//
// .hdf5  a snapshot as Gadget writes it (Springel, Simulating cosmic structure formation with GADGET-4, MNRAS 506,
// 2021,
//        appendix A): /Header with its attributes, /PartType1/Coordinates (N x 3, float64) and /PartType1/ParticleIDs
//        (uint64, from 1 on). monofonIC takes Header/BoxSize and the coordinates of it (its GlassFileName).
// .h5part  H5Part: /Step#0/x, y and z, float64, of the unit cube. SPH-EXA takes them (its --glass).
#pragma once

#include "base/points/point_file.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

/// True for names that end in .hdf5 or .h5part.
bool is_particle_file(const std::filesystem::path& path);

/// Writes `points` points of a cube, coordinates in [0, side), that `write` hands to the sink it is called with, whole
/// points at a time. A snapshot has BoxSize = side, and particles of one mass, side^3 in all; `unit` says what
/// lengths are in ("tiles"), and `comment` where the points come from. In H5Part files coordinates are divided by the
/// side. Whole or not at all. Throws InputError for more than 2^32 - 1 points and when `write` hands over another
/// number of them, StorageError when the file cannot be written.
void write_particles_in_pieces(const std::filesystem::path& path, std::size_t points, double side,
                               const std::string& unit, const std::string& comment,
                               const std::function<void(const PointSink& sink)>& write);

}
