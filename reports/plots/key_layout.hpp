// The labels in the key of a plot: how large, and in which lines, so that none runs out of the picture.
#pragma once

#include <string>
#include <vector>

namespace poissonlab {

/// About how wide a text is in DejaVu Sans, in units of the font size; other fonts without serifs are
/// narrower. Never too small for letters of European languages.
double text_width(const std::string& text);

/// Where and how large the text of a key may be, in pixels.
struct KeyRoom
{
    double font_size = 0;   ///< of full size
    double width = 0;       ///< for samples and texts
    double sample_size = 0; ///< what a line's sample takes at full size; it shrinks with the letters
};

struct KeyLayout
{
    double scale = 1;                            ///< size of the letters, 1: full
    std::vector<std::vector<std::string>> lines; ///< one line or two a label
};

/// The least size of letters.
inline constexpr double least_key_scale = 0.65;

/// Letters become smaller until all labels fit, down to the least size; then labels that are too wide get a
/// second line, broken at a comma if possible, with letters as large as that allows; then the second line is
/// shortened in the middle. Labels that differ still do.
KeyLayout lay_out_key(const std::vector<std::string>& labels, const KeyRoom& room);

}
