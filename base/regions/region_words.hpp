// These functions tell from its first words whether a text is a region, and of which kind; region_text.hpp reads it.
#pragma once

#include <string_view>

namespace poissonlab {

/// Is this a region by itself, of the plane or of space? Any other text is the name of a file.
bool is_region_text(std::string_view text);

/// Does it begin as WKT does?
bool is_wkt_text(std::string_view text);

/// Does it begin with the word, in letters of either case?
bool begins_with(std::string_view text, std::string_view word);

/// The text without a mark of byte order and without blanks at its ends.
std::string_view without_blanks_around(std::string_view text);

}
