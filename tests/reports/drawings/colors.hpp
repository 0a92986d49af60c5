// Colors that several tests of pictures look for.
#pragma once

#include <string>

namespace poissonlab {

inline const std::string black = "#000000";
inline const std::string white = "#ffffff";
inline const std::string red = "#ff0000";
inline const std::string blue = "#0000ff";

}
