// Where what is built once is kept for the programs to come, such as tile sets.
#pragma once

#include <filesystem>

namespace poissonlab {

/// $POISSONLAB_CACHE, else $XDG_CACHE_HOME/poissonlab, else ~/.cache/poissonlab; empty if the environment has none of
/// these.
std::filesystem::path cache_folder();

}
