#include "reports/images/spectrum_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace poissonlab {

namespace {

constexpr int largest_page_picture = 512;

/// White noise of one set has a power above this at one in 10^8 frequencies: a single one is a spike.
constexpr double spike = 20;

/// The mean power of a block, or the largest where that is a spike, which the mean would hide.
double shown_power(const Spectrum& spectrum, int fx, int fy, int block)
{
    double largest = 0;
    for (int y = fy; y < fy + block; ++y)
        for (int x = fx; x < fx + block; ++x)
            if (x != 0 || y != 0) largest = std::max(largest, spectrum.at(x, y));
    return largest > spike ? largest : mean_power(spectrum, fx, fy, block);
}

}

GreyImage draw_spectrum(const Spectrum& spectrum, const ToneMapping& tone_mapping, int block)
{
    const int lowest = -spectrum.size / 2;
    const int size = spectrum.size / block;
    GreyImage image(size, size, 0);
    const GreyScale grey(tone_mapping);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            image.at(column, size - 1 - row) =
                grey(shown_power(spectrum, lowest + column * block, lowest + row * block, block));
    return image;
}

Spectrum in_true_proportion(const Spectrum& plane, double column_side, double row_side)
{
    Spectrum stretched = plane;
    const int half = plane.size / 2;
    std::size_t pixel = 0;
    for (int q = -half; q < half; ++q)
        for (int p = -half; p < half; ++p, ++pixel) {
            const auto u = static_cast<int>(std::lround(p * column_side));
            const auto v = static_cast<int>(std::lround(q * row_side));
            stretched.power[pixel] = u == 0 && v == 0 && (p != 0 || q != 0) ? 0 : plane.at(u, v);
        }
    return stretched;
}

int page_block(int spectrum_size) { return block_for(spectrum_size, largest_page_picture); }

}
