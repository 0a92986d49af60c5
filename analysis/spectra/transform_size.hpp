// Sizes for which FFTW's transforms are fast.
#pragma once

#include <cmath>
#include <cstddef>

namespace poissonlab {

/// The smallest even size of at least `least` without other prime factors than 2, 3 and 5.
inline std::size_t transform_size(double least)
{
    for (auto size = static_cast<std::size_t>(std::ceil(least));; ++size) {
        std::size_t rest = size;
        for (const std::size_t factor : {2, 3, 5}) {
            while (rest % factor == 0) rest /= factor;
        }
        if (rest == 1 && size % 2 == 0) return size;
    }
}

/// The number of lines that are transposed together: two cache lines of complex numbers.
inline constexpr std::size_t transposed_lines = 8;

/// Room for a line: whole blocks, and not a power of two, for which a cache has few places.
inline std::size_t padded_line(std::size_t size)
{
    return ((size + transposed_lines - 1) / transposed_lines | 1) * transposed_lines;
}

}
