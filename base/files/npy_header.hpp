// Headers of NumPy files (.npy, version 1.0), which come before their numbers.
#pragma once

#include <string>
#include <string_view>

namespace poissonlab {

/// "<" or ">": how this machine's numbers lie in memory, for descriptions of types.
std::string_view npy_byte_order();

/// `descr` and `shape` as Python writes them: "'<f8'" and "(3, 2)". Numbers follow in C order.
std::string npy_header_of(std::string_view descr, std::string_view shape);

}
