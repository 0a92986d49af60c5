// The paths of files that the build has made, and that tests start and read. The definitions are in places.cpp alone,
// so that compiled tests do not depend on the folder they are built in.
#pragma once

#include <string>

namespace poissonlab {

std::string source_folder();     ///< of the checkout
std::string program_file();      ///< poissonlab
std::string example_file();      ///< runtime/example.cpp as a program
std::string bad_luck_file();     ///< the library that lets calls fail
std::string small_device_file(); ///< the library that tells of a smaller device
std::string code_files_list();   ///< which files each version of the code is a hash of
std::string core_sources_list(); ///< a file that names the source files of the core, a line each
std::string mpiexec_file();      ///< empty: there is no MPI

}
