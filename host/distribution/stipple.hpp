// Pictures in dots or strokes of one size, as dark as they are: stippling and hatching.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.3, figures 7.3 and 7.4, which gives no tone law.
// Marks of area a print the ink q a where there are q of them in a unit of area and they do not overlap, so that a
// picture of ink c has c / a of them: their number times their area is its ink, exactly, and so is their number in any
// part, up to how evenly they lie. Disks cannot cover more than 0.9069 rho^2 without overlapping, rho being their
// relative radius.
#pragma once

#include "base/densities/density.hpp"
#include "base/densities/density_values.hpp"
#include "host/distribution/ink/coverage.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/sampling/warp/warp.hpp"
#include "host/settings/distributions/distribution_config.hpp"

namespace poissonlab {

/// The ink of a picture's pixels, 0 to 1.
struct InkPicture
{
    PixelValues ink;
    Density density;  ///< the same in parts of the most
    double total = 0; ///< the sum over pixels
};

/// These words tell users that the ranks of the self-similar tile show its lattice.
inline constexpr auto lattice_words = "whose copies show as a lattice where the ink hardly changes";

/// 1 - the lightness of what has this ink, by CIE 1976 L*.
double ink_of_lightness(double ink);

/// The ink that settings ask for: the middle of the picture, by the zoom. Throws InputError for what cannot be read,
/// for ink below 0 or above 1, and for none.
InkPicture read_ink(const StippleSettings& settings);

struct Stippling
{
    SquarePoints even;     ///< the points before they were warped; of ranks empty
    PixelPlaces places;    ///< the middles of marks
    std::size_t asked = 0; ///< marks: by ranks there are some more or fewer
    double mark_area = 0;
    double mark_width = 0; ///< diameter of dots, or width of strokes, in pixels
    /// The nominal width is the one that the settings ask for, or else that of the marks. The marks differ from it a
    /// little, because their number is whole. The size of a sheet follows from it, so that the sheets of one picture's
    /// separations are equal.
    double nominal_width = 0;
    double margin = 0; ///< around the picture, in pixels: as wide as marks are long, for what lies beyond the picture
    MarkGroup marks;   ///< in pixels
};

/// The area of a mark of this width.
double mark_area(const StippleSettings& settings, double width);

/// The marks of a picture: as many as settings say, or as their width needs. By ranks their number is about that, and
/// their area follows. Throws InputError for no marks or too many.
Stippling stipple(const InkPicture& picture, const StippleSettings& settings, std::uint64_t seed,
                  const DistributionPlace& place);

/// Measures of how true the tones are.
struct TonesOfMarks
{
    double darkest_ink = 0; ///< beyond which marks overlap even where the ink is constant
    double too_dark = 0;    ///< the part of the pixels that have more
    double overlap = 0;     ///< the part of the laid ink that lies on other ink
    double error =
        0; ///< mean difference of ink, as a screen shows it, and of the ink asked for, over windows of 32 pixels
};

/// Tones of a stippling; `coverage` has the picture's pixels. `place` is where it was made.
TonesOfMarks tones_of(const InkPicture& picture, const StippleSettings& settings, const Stippling& stippling,
                      const Coverage& coverage, const DistributionPlace& place);

/// Writes pixels as grey: black where they are covered, and encoded as sRGB, so that a screen shows as much light as is
/// not covered. Throws StorageError.
void write_coverage(const std::filesystem::path& file, const Coverage& coverage);

/// The picture of the marks, whose size in units makes rounding to 0.01 of them small against a mark.
MarkPicture mark_picture(const InkPicture& picture, const Stippling& stippling);

}
