// The message of the InputError that reading a point file throws.
#pragma once

#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {

/// The message of the InputError that reading a file ends with, without the folder, so that it starts with the file
/// name.
inline std::string input_error_of(const std::filesystem::path& file)
{
    const std::string message = message_of([&] { read_points(file); });
    const std::string folder = file.parent_path().string() + "/";
    return message.starts_with(folder) ? message.substr(folder.size()) : message;
}

/// The message of the InputError that reading a file with that content ends with, from the file name on.
inline std::string input_error_of(const std::string& name, std::string_view content)
{
    const TemporaryFolder folder;
    return input_error_of(folder.write(name, content));
}

}
