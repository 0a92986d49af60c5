// The errors of pictures of the zone plate against the reference, in all and by distance from the origin.
#pragma once

#include "analysis/zone_plate/reconstruction.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// Roots of the mean squared difference of a picture from the reference.
///
/// Most of the picture lies where no set of one sample a pixel can follow the plate and every set has the
/// same error, so that `whole` says little. `resolved` is of the quarter of a disk that pixels can show.
struct PlateError
{
    double whole = 0;    ///< over all pixels
    double resolved = 0; ///< over those where the plate has up to half a cycle per pixel; NaN where there are
                         ///< none, as in pictures of less than 33 x 33 pixels
};

/// The pixels of one range of distances.
struct ErrorBin
{
    double distance = 0;    ///< of the middle of the range from the origin, in units of the plate [0, 48)
    double frequency = 0;   ///< of the plate there, in cycles per pixel
    double rms_error = 0;   ///< root of the mean squared difference from the reference over all pictures
    std::size_t pixels = 0; ///< of all pictures
};

/// The width of the ranges, in units of the plate: at the far corner, where the plate is finest, a range
/// spans some 11 of its cycles.
inline constexpr double error_bin_width = 0.5;

/// Adds up squared differences of pictures from zone_plate_reference of their size.
///
/// Pictures of realizations may differ in size, as saturated sets do; frequencies are those of the first.
class ZonePlateError
{
public:
    /// Adds a picture and returns its own error.
    PlateError add(const SquareImage& image);

    /// Appends the pictures of `other`; equal to adding them here, up to rounding.
    void append(const ZonePlateError& other);

    /// Ranges by distance of the pixels' centres, without those that hold no pixel.
    std::vector<ErrorBin> curve() const;

    /// The sums as bytes, which are read into an error that was constructed with the same reference.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(first_size_, squares_, pixels_);
    }

private:
    SquareImage reference_;
    int first_size_ = 0;
    std::vector<double> squares_;
    std::vector<std::size_t> pixels_;
};

}
