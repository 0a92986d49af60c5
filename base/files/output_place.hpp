// The bytes of a file that a user has named go to the file itself, to the one that a link leads to, into a
// device or a pipe, or to standard output.
#pragma once

#include <filesystem>

namespace poissonlab {

struct OutputPlace
{
    /// The file that is written, behind all links; for what takes bytes as they come, a name in the folder for
    /// temporary files, where a file can be made that is then copied.
    std::filesystem::path file;
    bool is_stream = false;         ///< a device, a pipe, an open file of this process
    int descriptor = -1;            ///< of that open file; -1: none, `stream` is opened by its name
    std::filesystem::path stream{}; ///< the name, behind all links
};

/// Follows links, also those that lead to files that are not there yet. /dev/stdout, /dev/fd/N and the like are open
/// files of this process: what is in them stays. "-" and names such as "-.png" are standard output once
/// keep_standard_output() has been called, and files before. Throws StorageError for links that lead in a circle.
OutputPlace output_place(const std::filesystem::path& path);

/// True for "-" and for "-" with an ending, such as "-.png", which says the format.
bool names_standard_output(const std::filesystem::path& path);

}
