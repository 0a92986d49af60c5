// This measures pictures of any origin as masks of thresholds: dither masks and textures of blue noise.
//
// A mask is periodic, because copies of it are laid side by side. Frequencies of W x H pixels are (u / W, v / H) cycles
// a pixel, and rings hold those of nearly one length. The values of a mask are measured by their power, which is 1 at
// all frequencies for white noise, and by how evenly they are spread over all possible ones (Ulichney 1993: The
// void-and-cluster method; Georgiev and Fajardo 2016: Blue-noise dithered sampling). The pixels below thresholds, which
// are what a mask is used for, are measured as point sets.
#pragma once

#include "host/kinds/kind.hpp"
#include "results/pictures/distribution_result.hpp"
#include "results/pictures/mark_picture.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// These are the keys of kind = "mask-picture".
struct MaskPictureSettings
{
    std::filesystem::path mask;
    std::string channel; ///< empty: the only one, or the one that all colours have in common
};

/// A mask has its values row after row from the top.
struct MaskPicture
{
    std::uint32_t width = 0, height = 0;
    std::vector<double> values; ///< as the file has them: of 8 and 16 bits whole numbers
    double low = 0, high = 1;   ///< the least and the largest value that there could be
    std::uint32_t codes = 0;    ///< how many values there could be; 0: any number
    std::string note{};         ///< what of the file was left out

    std::size_t pixels() const { return values.size(); }
};

/// Reads a mask. Throws InputError, one line, where the file is not a picture, a number is not finite, channels differ
/// and none is chosen, or all pixels have one value.
MaskPicture read_mask_picture(const MaskPictureSettings& settings);

/// Returns the power of a field of W x H numbers, by FFTW, over the sum of their squares: it is 1 on average. A row has
/// the frequencies (u, v) of one v, and both begin at 0.
std::vector<double> field_power(const std::vector<double>& values, std::uint32_t width, std::uint32_t height);

/// These are means over rings of frequencies up to half a cycle a pixel. There is a ring for every two pixels of the
/// mask's shorter side; (u, v) and (-u, -v) count once.
struct RingPower
{
    std::vector<double> frequency; ///< of the ring's middle, cycles a pixel
    std::vector<double> power;
    std::vector<double> anisotropy; ///< variance over the square of the mean; 1 for noise without directions
};
RingPower ring_power(const std::vector<double>& power, std::uint32_t width, std::uint32_t height);

/// The mean power of frequencies below `end`, in cycles a pixel.
double mean_power_below(const RingPower& rings, double end);

/// This is measured of the pixels below a threshold or, where these are more than half, of those that are not.
struct MaskLevel
{
    double threshold = 0; ///< a value of the mask
    std::size_t below = 0;
    double least_distance = 0; ///< pixels
    double mean_nearest = 0;   ///< over the largest least distance of as many points
    double low_power = 0;      ///< mean power of frequencies below half of the principal one; random pixels have 1
    RingPower rings;           ///< of the power over the number of pixels
};

/// Measures the pixels below thresholds that divide them by sixteenths, or nearly; masks of few values have fewer.
std::vector<MaskLevel> mask_levels(const MaskPicture& mask);

/// Returns the largest difference between the part of the pixels that have a value or less, and that of an even
/// histogram.
double histogram_error(const MaskPicture& mask);

/// Returns kind = "mask-picture", which measures a mask.
Kind mask_picture_kind();

}
