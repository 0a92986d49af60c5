#include "tests/support/places.hpp"

namespace poissonlab {

std::string source_folder() { return POISSONLAB_SOURCE_DIR; }
std::string program_file() { return POISSONLAB_BUILD_DIR "/poissonlab"; }
std::string example_file() { return POISSONLAB_BUILD_DIR "/poisson_tiles_example"; }
std::string bad_luck_file() { return POISSONLAB_BUILD_DIR "/libbad_luck.so"; }
std::string small_device_file() { return POISSONLAB_BUILD_DIR "/libsmall_device.so"; }
std::string code_files_list() { return POISSONLAB_BUILD_DIR "/generated/code_files.txt"; }
std::string core_sources_list() { return POISSONLAB_BUILD_DIR "/generated/core_sources.txt"; }
std::string mpiexec_file() { return POISSONLAB_MPIEXEC; }

}
