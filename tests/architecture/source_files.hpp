// The source files of the checkout, as tests of its rules read them.
#pragma once

#include <string>
#include <vector>

namespace poissonlab::test {

struct SourceFile
{
    std::string path; ///< from the root, "host/sampling/sampler.hpp"
    std::string text;

    std::string room() const { return path.substr(0, path.find('/')); }
    std::string folder() const; ///< empty: the root
    std::string kind() const;   ///< ".cpp"; empty where the name has no ending

    /// True for the C++ of the rooms and of tests, headers in C as well.
    bool is_cpp() const;

    /// True where comments begin with #: CMake, Python and shell.
    bool has_hash_comments() const;
};

/// All source files of the rooms, of tests, of cmake/ and docs/, and those in the root, in the order of their paths: C,
/// C++, OpenCL C, languages of shaders, JavaScript, CMake, Python, shell. They are read once.
const std::vector<SourceFile>& source_files();

}
