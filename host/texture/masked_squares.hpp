// Sums of squared differences between a piece and every window of an exemplar, over a mask: exact integers.
//
// Sum of m (I - S)^2 = sum of m I^2 - 2 sum of m I S + sum of m S^2: two correlations, by FFT. Their values are
// integers below 2^53, so that rounding makes them exact. After Kwatra, Schoedl, Essa, Turk, Bobick, Graphcut textures,
// SIGGRAPH 2003, section 4.
#pragma once

#include "base/images/png_file.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace poissonlab {

/// Pixels of a piece that count: those where it is 1, row by row.
struct PieceMask
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> counts;
};

/// A sum for each place of the window's upper left corner in the exemplar, row by row.
struct SquareSums
{
    int columns = 0;
    int rows = 0;
    std::vector<std::uint64_t> sums;

    std::uint64_t at(int x, int y) const
    {
        return sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x)];
    }
};

/// Sums of many pieces with one mask. Callable from several threads at a time.
class MaskedSquares
{
public:
    /// Windows must fit into the exemplar.
    MaskedSquares(const PngPixels& exemplar, const PieceMask& mask);
    ~MaskedSquares();

    /// The piece has the mask's size and the exemplar's channels.
    SquareSums sums(const PngPixels& piece) const;

private:
    struct Spectra;
    std::unique_ptr<Spectra> spectra_;
};

}
