// The folder that keeps what is built once, such as tile sets, for the programs to come.
#pragma once

#include <filesystem>

namespace poissonlab {

/// $POISSONLAB_CACHE, else $XDG_CACHE_HOME/poissonlab, else ~/.cache/poissonlab; empty if the environment has none of
/// these.
std::filesystem::path cache_folder();

}
