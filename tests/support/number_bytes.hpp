// The bytes of numbers, one after the other, in either order.
#pragma once

#include <algorithm>
#include <bit>
#include <string>

namespace poissonlab::test {

/// The first byte is the last one of a number where they are big-endian.
template <class... Numbers>
std::string number_bytes(std::endian order, Numbers... numbers)
{
    std::string bytes;
    const auto append = [&](auto number) {
        std::string one(reinterpret_cast<const char*>(&number), sizeof(number));
        if (order != std::endian::native) std::ranges::reverse(one);
        bytes += one;
    };
    (append(numbers), ...);
    return bytes;
}

}
