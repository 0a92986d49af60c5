// Puts binary files together, byte by byte.
#pragma once

#include <algorithm>
#include <bit>
#include <string>

namespace poissonlab {

/// `value` as bytes in that order.
template <class T>
std::string bytes_of(T value, std::endian order)
{
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(T));
    if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

}
