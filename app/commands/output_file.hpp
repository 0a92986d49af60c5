// The files that commands write: what their names may end in, and whether they can be written, both told before any
// work is done.
#pragma once

#include "reports/drawings/drawing.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The formats that an option which names a file accepts.
struct OutputFormats
{
    std::vector<std::string> endings; ///< of names, ".svg"; the first is what "-" means where points cannot be written
    bool may_be_points = false;       ///< also a point file, whose name may have no ending: text
    bool may_lack_ending = false;     ///< a name without an ending is as good
    std::string with_second_file{};   ///< the ending of a format of two files, which standard output has no room for
};

/// Point files and nothing else.
inline OutputFormats point_formats() { return {{}, true}; }

/// The name as the format's writer needs it: "-" gets the first ending, "-.svg", unless it is text.
std::filesystem::path output_name(const std::filesystem::path& file, const OutputFormats& formats);

/// Throws InputError for another ending, a folder that is not there and a name that is one, and StorageError for what
/// may not be written; links are followed. Where the file is standard output, what the program prints goes to standard
/// error from now on. `command` is "distribute warp" and so on, `option` is "--out". Returns the name as the writer
/// needs it.
std::filesystem::path checked_output(const std::string& command, const std::string& option,
                                     const std::filesystem::path& file, const OutputFormats& formats);

/// ".svg, .png or .csv"
std::string either(const std::vector<std::string>& words);

// Pictures that commands write: a drawing as SVG or PNG, as the file's name says.

/// A drawing's.
inline OutputFormats picture_formats() { return {{".svg", ".png"}}; }

/// Writes a drawing; as PNG so many pixels wide, 0: two a unit. Throws StorageError.
void write_picture_file(const std::filesystem::path& file, const Drawing& drawing, int pixels = 0);

}
