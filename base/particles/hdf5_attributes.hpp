// Attributes of HDF5 as numbers, of whatever shape: one number, rows of them, or an array as its type.
#pragma once

#include "base/particles/hdf5_objects.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

bool has_link(hid_t file, const std::string& name);

/// All numbers of an attribute; nothing where the object has none of the name. `shown` is what messages call it. Throws
/// InputError without the file's name for one that does not hold numbers.
std::optional<std::vector<double>> attribute_numbers(hid_t object, const char* name, const std::string& shown);

/// That of a group, GROUP/NAME; nothing where one of them is not there.
std::optional<std::vector<double>> group_numbers(hid_t file, const std::string& group, const char* name);

}
