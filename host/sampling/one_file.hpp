// A parameter that names one file.
#pragma once

#include "host/sampling/parameters.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// Returns the file that a parameter of the kind `paths` names, by its path from the folder of the config. Throws
/// InputError, with the place, where there is none or where there are several.
std::filesystem::path one_file(const Parameters& given, const std::string& key);

}
