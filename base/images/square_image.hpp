// A square picture of grey values.
//
// Square images, such as pictures of the zone plate, as OpenEXR images of float32, channel "Y".
//
// Unlike a spectrum's, the first line of the file is the highest y: viewers show the origin at the lower
// left, where the dissertation has it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace poissonlab {

/// Grey values over the unit square. Row-major, row 0 has the lowest y; pixel (i, j) has its centre at
/// ((i + 1/2) / size, (j + 1/2) / size).
struct SquareImage
{
    int size = 0; ///< pixels along each axis
    std::vector<double> pixels;

    double at(int column, int row) const
    {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                      static_cast<std::size_t>(column)];
    }
};

/// `metadata` (config, seed, label ...) goes into the header as string attributes "poissonlab:meta:<name>".
/// Writes to a temporary name, then renames. Throws StorageError.
void write_square_image(const std::filesystem::path& path, const SquareImage& image,
                        const std::map<std::string, std::string>& metadata);

/// Reads what write_zone_plate wrote. Throws InputError for files that are not such pictures.
SquareImage read_square_image(const std::filesystem::path& path);

}
