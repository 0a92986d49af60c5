#include "reports/images/spectrum_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace poissonlab {
namespace {

constexpr int largest_page_picture = 512;

/// Noise of one set has a power above so many times that of its ring at one in 10^8 frequencies: a single one is a
/// spike.
constexpr double spike = 20;

/// The largest powers of a ring, which may be its spikes, are left out of its mean, unless the ring is small.
constexpr std::size_t most_spikes = 12, least_part = 4;

std::size_t ring_of(const Spectrum& spectrum, int x, int y)
{
    return static_cast<std::size_t>(std::lround(std::hypot(x / spectrum.box.sides[0], y / spectrum.box.sides[1])));
}

/// The powers of rings above which one is a spike.
std::vector<double> least_spikes(const Spectrum& spectrum)
{
    const int half = spectrum.size / 2;
    std::vector<std::vector<double>> rings(ring_of(spectrum, half, half) + 1);
    for (int y = -half; y < half; ++y)
        for (int x = -half; x < half; ++x)
            if (x != 0 || y != 0) rings[ring_of(spectrum, x, y)].push_back(spectrum.at(x, y));
    std::vector<double> least;
    for (std::vector<double>& powers : rings) {
        const std::size_t kept = powers.size() - std::min(most_spikes, powers.size() / least_part);
        std::ranges::nth_element(powers, powers.begin() + static_cast<std::ptrdiff_t>(kept));
        powers.resize(kept);
        least.push_back(spike * std::accumulate(powers.begin(), powers.end(), 0.0) /
                        static_cast<double>(std::max<std::size_t>(kept, 1)));
    }
    return least;
}

/// The mean power of a block, or the largest spike, which the mean would hide.
double shown_power(const Spectrum& spectrum, const std::vector<double>& least, int fx, int fy, int block)
{
    double largest = 0;
    for (int y = fy; y < fy + block; ++y)
        for (int x = fx; x < fx + block; ++x)
            if ((x != 0 || y != 0) && spectrum.at(x, y) > least[ring_of(spectrum, x, y)])
                largest = std::max(largest, spectrum.at(x, y));
    return largest > 0 ? largest : mean_power(spectrum, fx, fy, block);
}

}

GreyImage draw_spectrum(const Spectrum& spectrum, const ToneMapping& tone_mapping, int block)
{
    const int lowest = -spectrum.size / 2;
    const int size = spectrum.size / block;
    GreyImage image(size, size, 0);
    const GreyScale grey(tone_mapping);
    const std::vector<double> least = least_spikes(spectrum);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column)
            image.at(column, size - 1 - row) =
                grey(shown_power(spectrum, least, lowest + column * block, lowest + row * block, block));
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

namespace {

constexpr double white_density = 2;

}

GreyImage draw_density(const SquareImage& image, int magnification)
{
    const int size = image.size * magnification;
    GreyImage grey(size, size, 0);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double share = image.at(column / magnification, row / magnification) / white_density;
            grey.at(column, size - 1 - row) = static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
        }
    return grey;
}

}
