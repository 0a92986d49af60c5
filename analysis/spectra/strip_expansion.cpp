#include "analysis/spectra/strip_expansion.hpp"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace poissonlab {

namespace {

/// cos and sin of pi m / B for m = 0 .. 2B - 1: all that strip centres and powers of i need.
struct CircleTable
{
    std::vector<double> cosine, sine;

    explicit CircleTable(int strips) : cosine(2 * static_cast<std::size_t>(strips)), sine(cosine.size())
    {
        for (std::size_t m = 0; m < cosine.size(); ++m) {
            const double angle = std::numbers::pi * static_cast<double>(m) / strips;
            cosine[m] = std::cos(angle);
            sine[m] = std::sin(angle);
        }
        // The quarter turns are exact, so that an axis of frequency zero has imaginary part zero, exactly.
        const auto quarter = static_cast<std::size_t>(strips / 2);
        cosine[quarter] = cosine[3 * quarter] = 0.0;
        sine[0] = sine[2 * quarter] = 0.0;
    }
};

void fill_row(const StripExpansion& e, const CircleTable& circle, int v, double* cosine, double* sine)
{
    std::vector<double> bessel(static_cast<std::size_t>(e.terms));
    const double z = std::numbers::pi * v / e.strips;
    for (int r = 0; r < e.terms; ++r) bessel[r] = (r == 0 ? 1.0 : 2.0) * ::jn(r, z);

    // 2 pi v c_k + r pi/2 in units of pi/B: v (2k + 1) + r B/2, taken modulo 2B in integers.
    const auto mask = 2 * static_cast<unsigned long>(e.strips) - 1;
    for (int k = 0; k < e.strips / 4; ++k) {
        for (int r = 0; r < e.terms; ++r) {
            const auto m = (static_cast<unsigned long>(v) * (2 * k + 1) + r * (e.strips / 2)) & mask;
            *cosine++ = bessel[r] * circle.cosine[m];
            *sine++ = bessel[r] * circle.sine[m];
        }
    }
}

}

int expansion_terms(int strips, int max_frequency)
{
    const double half_z = 0.5 * std::numbers::pi * max_frequency / strips;
    const double limit = std::log(0.5 * std::numeric_limits<double>::epsilon());
    double log_term = std::log(2.0); // of 2 (z/2)^R / R!, which overflows itself on the way for wide strips
    for (int terms = 1;; ++terms) {
        log_term += std::log(half_z / terms);
        const double ratio = half_z / (terms + 1);
        if (ratio < 1.0 && log_term - std::log(1.0 - ratio) < limit) return terms;
    }
}

StripExpansion cheapest_expansion(std::size_t points, int size)
{
    // Each row of frequencies takes 4 N R operations for the moments, and 2 (M/2 + 1) B R to use them.
    StripExpansion best;
    double least = std::numeric_limits<double>::infinity();
    for (int strips = 4; strips <= 4 * size; strips *= 2) {
        const int terms = expansion_terms(strips, size / 2);
        const double cost =
            terms * (4.0 * static_cast<double>(points) + 2.0 * (size / 2 + 1) * static_cast<double>(strips));
        if (cost < least) {
            least = cost;
            best = {strips, terms};
        }
    }
    return best;
}

StripCoefficients strip_coefficients(const StripExpansion& expansion, int max_frequency)
{
    const CircleTable circle(expansion.strips);
    const std::size_t width = expansion.folded_moments();
    StripCoefficients table;
    for (int odd = 0; odd < 2; ++odd) {
        const auto rows = static_cast<std::size_t>((max_frequency - odd) / 2 + 1);
        table.cosine[odd].resize(rows * width);
        table.sine[odd].resize(rows * width);
    }
    tbb::parallel_for(0, max_frequency + 1, [&](int v) {
        const std::size_t row = static_cast<std::size_t>(v / 2) * width;
        fill_row(expansion, circle, v, &table.cosine[v % 2][row], &table.sine[v % 2][row]);
    });
    return table;
}

std::array<int, 4> folded_strips(const StripExpansion& expansion, int k)
{
    const int half = expansion.strips / 2;
    return {k, half - 1 - k, half + k, expansion.strips - 1 - k};
}

void fold(const std::array<const double*, 4>& moments, int terms, std::size_t columns, bool odd_frequency,
          double* cosine, double* sine)
{
    // A shift by 1/2 is a factor s = (-1)^v. Reflection c -> 1/2 - c turns cos(2 pi v c + r pi/2) into
    // s (-1)^r times itself and sin(...) into -s (-1)^r times itself.
    const double s = odd_frequency ? -1.0 : 1.0;
    for (int r = 0; r < terms; ++r) {
        const double reflection = r % 2 == 0 ? s : -s;
        const std::size_t row = static_cast<std::size_t>(r) * columns;
        for (std::size_t i = row; i < row + columns; ++i) {
            const double direct = moments[0][i] + s * moments[2][i];
            const double reflected = reflection * (moments[1][i] + s * moments[3][i]);
            cosine[i] = direct + reflected;
            sine[i] = direct - reflected;
        }
    }
}

}
