// Which versions of the code stored work depends on.
#pragma once

#include <string>

namespace poissonlab {

/// Hashes of source files, see cmake/code_versions.cmake.
struct CodeVersions
{
    std::string sampling; ///< of point sets
    std::string analysis; ///< of what is measured on them
    std::string pictures; ///< of tilings and constructions
    std::string distributions;

    /// The version on which the kinds of a table depend.
    std::string of_table(const std::string& table) const
    {
        if (table == "construction") return pictures;
        return table == "tiling" || table == "tile_set" ? pictures + analysis : distributions;
    }

    /// The versions of this program.
    static CodeVersions current();
};

}
