// Pictures and formulas as plain numbers: what densities, inks, heights and vector fields are made of.
#pragma once

#include "base/errors/errors.hpp"
#include "base/images/linear_picture.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// A picture has no channel of this name. Who knows the key that named it says it of that key.
class UnknownChannel : public InputError
{
public:
    using InputError::InputError;
};

/// Numbers of a rectangle's pixels, row by row from the bottom: y goes up.
struct PixelValues
{
    int width = 0;
    int height = 0;
    std::vector<double> values;
    std::string note{}; ///< as that of Density

    double at(int column, int row) const
    {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(column)];
    }
};

/// Sets numbers to 0 that rounding left below it, as lossy compression does (DWA in OpenEXR) and resampling: those down
/// to a tenth of the mean below 0, if all of them together are at most a thousandth of the sum of the others. Returns a
/// note for users that begins with the name, or nothing where no number changes. Others are left for those to refuse
/// who want none below 0.
std::string clamp_rounding(std::vector<double>& values, const std::string& name);

/// The numbers of a picture. `channel` says what of it: "light", its luminance; "ink", 1 - luminance, which is at least
/// 0 but for clamp_rounding(); or the name of a channel. Throws InputError, one line with the picture's name:
/// an UnknownChannel for an unknown channel, a plain one for ink of pixels that are brighter than 1. Pixels are named
/// by column and row from the top left.
PixelValues picture_values(const LinearPicture& picture, std::string_view channel, const std::string& name);

/// The numbers of a formula in the middles of pixels: see density_of_formula(), which refuses some of them. Throws
/// InputError, one line with the formula, for one that cannot be understood.
PixelValues formula_values(const std::string& formula, double width, double height);

/// The numbers of the picture of that name, of which `from` is taken, or of a formula over a rectangle of these
/// proportions. Throws InputError, one line, for what is neither.
PixelValues values_of_text(const std::string& text, const std::string& from, double width, double height);

/// The middle of a rectangle, one over the zoom of each side; at least a pixel.
PixelValues middle_of(PixelValues values, double zoom);

/// The error of a text that is no formula, and may have been meant as the name of a file.
InputError formula_error(const std::string& text, const InputError& error);

/// A pixel by column and row from the top left, as programs for pictures name it; `index` is from the bottom.
std::string pixel_name(int width, int height, std::size_t index);

}
