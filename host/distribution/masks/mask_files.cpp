#include "host/distribution/masks/mask_files.hpp"

#include "base/files/npy_header.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

/// BART's arrays: real and imaginary part of each value in floats of the machine, the first dimension fastest. The
/// header names 16 dimensions, of which readout is the first and phase encodings are the second and third.
void write_bart(const std::filesystem::path& file, const SamplingMask& mask)
{
    const std::vector<std::uint8_t> pixels = mask.pixels();
    std::vector<float> values;
    values.reserve(2 * pixels.size());
    for (std::uint32_t column = 0; column < mask.columns; ++column)
        for (std::uint32_t row = 0; row < mask.rows; ++row) {
            values.push_back(pixels[std::size_t{row} * mask.columns + column]);
            values.push_back(0);
        }
    std::filesystem::path header = file;
    header.replace_extension(".hdr");
    write_whole_file(header, fmt::format("# Dimensions\n1 {} {} 1 1 1 1 1 1 1 1 1 1 1 1 1\n", mask.rows, mask.columns));
    write_whole_file(file,
                     std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)));
}

}

void write_mask(const std::filesystem::path& file, const SamplingMask& mask)
{
    if (file.extension() == ".cfl") return write_bart(file, mask);
    std::vector<std::uint8_t> pixels = mask.pixels();
    if (file.extension() == ".png") {
        for (std::uint8_t& pixel : pixels) pixel = pixel == 0 ? 0 : 255;
        return write_png(file, {static_cast<int>(mask.columns), static_cast<int>(mask.rows), 1},
                         [&](int first, int) { return &pixels[static_cast<std::size_t>(first) * mask.columns]; });
    }
    write_whole_file(file, npy_header_of("'|u1'", fmt::format("({}, {})", mask.rows, mask.columns)) +
                               std::string(pixels.begin(), pixels.end()));
}

}
