#include "reports/images/plane_image.hpp"

#include "reports/images/spectrum_image.hpp"

#include <algorithm>
#include <array>

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
            if (inside && (rows.at(static_cast<std::size_t>(y / scale)) & bit)) image.at(left + x, top + y) = 0;
        }
}

void copy(const GreyImage& from, GreyImage& to, int left, int top)
{
    GreyImage source = from;
    for (int row = 0; row < from.height; ++row)
        for (int column = 0; column < from.width; ++column) to.at(left + column, top + row) = source.at(column, row);
}

}

namespace {

// A spectrum with its name above it.
struct NamedPlane
{
    const Spectrum& spectrum;
    std::string name;
    int column = 0;
    int row = 0;
};

GreyImage draw_planes(const std::vector<NamedPlane>& planes, const ToneMapping& tone_mapping, int block)
{
    const int size = planes.front().spectrum.size / block;
    const int scale = std::max(1, size / 128);
    const int strip = (letter_height + 5) * scale;
    const int gap = 2 * scale;
    const int columns = std::ranges::max_element(planes, {}, &NamedPlane::column)->column + 1;
    const int rows = std::ranges::max_element(planes, {}, &NamedPlane::row)->row + 1;
    GreyImage image(columns * (size + gap) - gap, rows * (strip + size), 255);
    for (const NamedPlane& plane : planes) {
        const int left = plane.column * (size + gap);
        const int top = plane.row * (strip + size);
        copy(draw_spectrum(plane.spectrum, tone_mapping, block), image, left, top + strip);
        int at = left + scale;
        for (const char letter : plane.name) {
            draw_letter(image, letter, at, top + 3 * scale, scale);
            at += (letter_width + 1) * scale;
        }
    }
    return image;
}

}

GreyImage draw_spectrum_planes(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping, int block)
{
    return draw_planes({{planes.at(0), "xy", 0, 1}, {planes.at(1), "xz", 0, 0}, {planes.at(2), "yz", 1, 0}},
                       tone_mapping, block);
}

GreyImage draw_plane_row(const std::vector<Spectrum>& planes, const std::vector<std::string>& names,
                         const ToneMapping& tone_mapping, int block)
{
    std::vector<NamedPlane> row;
    for (std::size_t i = 0; i < planes.size(); ++i) row.push_back({planes[i], names.at(i), static_cast<int>(i), 0});
    return draw_planes(row, tone_mapping, block);
}

Spectrum spectrum_close_up(const Spectrum& plane)
{
    const int half = std::max(1, 5 * plane.size / 16);
    Spectrum middle{2, 2 * half, plane.points, plane.realizations, {}};
    for (int y = -half; y < half; ++y)
        for (int x = -half; x < half; ++x) middle.power.push_back(plane.at(x, y));
    return middle;
}

}
