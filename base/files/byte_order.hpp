// Numbers in binary files of either byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace poissonlab {

/// The T in the first bytes of `bytes`, which are enough.
template <class T>
T load(std::string_view bytes, std::endian order)
{
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes.data(), sizeof(T));
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
}

}
