// Files of points that have classes.
#pragma once

#include "base/regions/plane_region.hpp"
#include "host/sampling/classes/class_darts.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// The ends of names of files of points with classes: .csv (columns x, y, in 3D z, class), .ply (ascii, vertices with
/// the property class) and .npy (records of these fields).
const std::vector<std::string>& class_file_ends();

/// Writes points in one of these formats, whole or not at all. Numbers read back are the same doubles. Throws
/// StorageError. Coordinates are those of the region's file, if there is a region. `features` has for each
/// point the GeoJSON members of its feature of the region's file, see RegionFeature::id; it may be empty.
void write_class_file(const std::filesystem::path& file, const ClassedPoints& points, const std::string& comment,
                      const PlaneRegion* region = nullptr, const std::vector<std::string>& features = {});

/// Takes some points, coordinate after coordinate, and the class of each.
using ClassedPointSink =
    std::function<void(std::span<const double> coordinates, std::span<const std::uint32_t> classes)>;

/// Writes so many points, which `source` hands on in pieces, in one of these formats. Their coordinates are those
/// of the region's file, if there is a region.
void write_class_pieces(const std::filesystem::path& file, int dimension, std::size_t points,
                        const std::string& comment, const std::function<void(const ClassedPointSink&)>& source,
                        const PlaneRegion* region = nullptr, const std::vector<std::string>& features = {});

/// The classes alone, as a NumPy array of uint32.
void write_class_numbers(const std::filesystem::path& file, const std::vector<std::uint32_t>& classes);

}
