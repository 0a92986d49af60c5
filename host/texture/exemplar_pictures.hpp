// The pictures of a texture set from their files: what it is cut by, and what is cut as well.
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct ExemplarPictures
{
    PngPixels exemplar;                   ///< of 8 bits, by which windows are chosen and cuts are made
    int split = 0;                        ///< the column where that of marked corners begins; 0: there is none
    std::vector<CompanionMap> companions; ///< an exemplar of more than 8 bits as its file has it, then those asked for
    std::vector<std::string> notes;       ///< lines that a person should read
    bool is_flattened = false;            ///< see flatten()
};

/// Checks names and sizes of companions from their headers, before any work. Throws InputError that begins with the
/// name of the file: of another size than the exemplar, with numbers of another kind, or called as another companion.
void check_companions(const std::filesystem::path& exemplar, const std::vector<std::filesystem::path>& also);

/// Reads the pictures of a set; `marked_exemplar` may be empty. Exemplars of 16 bits and of floating-point numbers are
/// companions as well. Throws InputError as read_exemplar() and check_companions() do.
ExemplarPictures read_exemplar_pictures(const std::filesystem::path& exemplar,
                                        const std::filesystem::path& marked_exemplar,
                                        const std::vector<std::filesystem::path>& also);

/// Straightens all pictures of a set for tiles of that size. Throws InputError as straightening_for() does.
void straighten(ExemplarPictures& pictures, int size);

/// Flattens the exemplar for tiles of that size, and its original, where that is asked for; where nothing is asked for,
/// if its light differs over more than a tile. Other companions stay as they are: what varies slowly in heights or
/// normals is no light. A note says what is done.
void flatten(ExemplarPictures& pictures, int size, std::optional<bool> is_asked);

}
