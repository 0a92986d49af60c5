// The oracle of masked sums of squares.
#pragma once

#include "host/texture/masked_squares.hpp"

#include <cstddef>

namespace poissonlab::test {

/// Finds the sums of a piece by adding up every product.
inline SquareSums plain_masked_squares(const PngPixels& exemplar, const PieceMask& mask, const PngPixels& piece)
{
    SquareSums result{exemplar.width - mask.width + 1, exemplar.height - mask.height + 1, {}};
    result.sums.resize(static_cast<std::size_t>(result.columns) * static_cast<std::size_t>(result.rows));
    for (int oy = 0; oy < result.rows; ++oy)
        for (int ox = 0; ox < result.columns; ++ox) {
            std::uint64_t sum = 0;
            for (int y = 0; y < mask.height; ++y)
                for (int x = 0; x < mask.width; ++x) {
                    if (mask.counts[static_cast<std::size_t>(y * mask.width + x)] == 0) continue;
                    for (int c = 0; c < piece.channels; ++c) {
                        const int difference =
                            piece.values[piece.at(x, y, c)] - exemplar.values[exemplar.at(ox + x, oy + y, c)];
                        sum += static_cast<std::uint64_t>(difference * difference);
                    }
                }
            result.sums[static_cast<std::size_t>(oy) * static_cast<std::size_t>(result.columns) +
                        static_cast<std::size_t>(ox)] = sum;
        }
    return result;
}

}
