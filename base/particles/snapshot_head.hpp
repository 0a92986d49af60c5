// These functions read the header of a snapshot and find its files: see base/points/hdf5_reading.hpp.
#pragma once

#include "base/particles/hdf5_objects.hpp"
#include "base/points/hdf5_reading.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

inline constexpr std::size_t particle_types = 7; ///< SWIFT has neutrinos as the last one, Gadget has six

/// The numbers of particles of each type.
using ParticleCounts = std::array<std::uint64_t, particle_types>;

/// The sides of the box that a file declares.
struct BoxSides
{
    std::vector<double> sides{}; ///< one, or one along each axis; empty: the file has none
    std::string name{};          ///< what messages call them
    std::string problem{};       ///< what is wrong with them, which matters only where they are needed
};

BoxSides read_box(hid_t file);

/// One file of a snapshot.
struct SnapshotPart
{
    std::filesystem::path path;
    ParticleCounts rows{};                         ///< of the tables that are there
    std::optional<ParticleCounts> said{}, total{}; ///< by the header: of this file, and of all
    std::uint64_t files = 1;                       ///< of the snapshot
    BoxSides box{};
};

/// "PartType1/Coordinates".
std::string coordinates_of_type(std::size_t type);

/// Throws InputError for attributes that no such file has.
SnapshotPart read_snapshot_part(const std::filesystem::path& path, hid_t file);

/// All files of the snapshot of which one is named, in their order. Throws InputError where one is missing.
std::vector<SnapshotPart> read_snapshot(const std::filesystem::path& path);

/// The names alone, and that of the first that is missing, or empty. A single name where the others cannot be told.
std::pair<std::vector<std::filesystem::path>, std::filesystem::path> names_of_parts(const SnapshotPart& part);

/// The type whose particles are the points: the one that is asked for, or the only one. Throws InputError; and where
/// the file does not have as many as its header says.
std::size_t type_of_points(const std::vector<SnapshotPart>& parts, const PointReading& how);

}
