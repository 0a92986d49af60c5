#include "reports/plane_image.hpp"

#include "reports/spectrum_image.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace poissonlab {

namespace {

constexpr int letter_width = 5;
constexpr int letter_height = 5;

// The three letters that name planes, row by row; a set bit of a row is black, the leftmost the highest.
constexpr std::array<std::array<unsigned, letter_height>, 3> letters = {{
    {0b10001, 0b01010, 0b00100, 0b01010, 0b10001}, // x
    {0b10001, 0b10001, 0b01111, 0b00001, 0b01110}, // y
    {0b11111, 0b00010, 0b00100, 0b01000, 0b11111}, // z
}};

void draw_letter(GreyImage& image, char letter, int left, int top, int scale)
{
    const auto& rows = letters.at(static_cast<std::size_t>(letter - 'x'));
    for (int y = 0; y < letter_height * scale; ++y)
        for (int x = 0; x < letter_width * scale; ++x) {
            const unsigned bit = 1U << (letter_width - 1 - x / scale);
            const bool inside = left + x < image.width && top + y < image.height;
            if (inside && (rows.at(static_cast<std::size_t>(y / scale)) & bit))
                image.at(left + x, top + y) = 0;
        }
}

void copy(const GreyImage& from, GreyImage& to, int left, int top)
{
    GreyImage source = from;
    for (int row = 0; row < from.height; ++row)
        for (int column = 0; column < from.width; ++column)
            to.at(left + column, top + row) = source.at(column, row);
}

}

GreyImage draw_spectrum_planes(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping,
                               int block)
{
    const int size = planes.front().size / block;
    const int scale = std::max(1, size / 128);
    const int strip = (letter_height + 5) * scale; // a plane's name above it
    const int gap = 2 * scale;
    GreyImage image(2 * size + gap, 2 * (strip + size), 255);
    constexpr std::array<std::array<int, 2>, 3> places = {{{0, 1}, {0, 0}, {1, 0}}}; // column and row
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const int left = places.at(i)[0] * (size + gap);
        const int top = places.at(i)[1] * (strip + size);
        copy(draw_spectrum(planes[i], tone_mapping, block), image, left, top + strip);
        int at = left + scale;
        for (const char letter : std::string_view(plane_names.at(i))) {
            draw_letter(image, letter, at, top + 3 * scale, scale);
            at += (letter_width + 1) * scale;
        }
    }
    return image;
}

}
