// Modules of the laboratory: shared libraries that hold a library which few commands need and which takes long to load.
#pragma once

#include <filesystem>
#include <string>

namespace poissonlab {

/// The address of a function of the module `name`, such as "poissonlab_pictures", which is loaded and stays so. The
/// module is beside the program, or where it is when it is installed with the program or the Python package, or where
/// it was built. Throws StorageError where there is no such file, or where it, or a library of it, cannot be loaded:
/// `need` begins the message, such as "pictures need OpenImageIO". A missing file that ./lab adds throws MissingModule.
void* function_of_module(const std::string& name, const char* function, const char* need, bool is_added_by_lab = false);

/// Returns the folder share/poissonlab of an installed program, which holds its configs and tile sets. It need not
/// exist: a program in a build folder has none.
std::filesystem::path installed_data_folder();

}
