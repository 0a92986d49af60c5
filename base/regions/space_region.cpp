#include "base/regions/space_region.hpp"

#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/points/point_file.hpp"
#include "base/text/decimal_commas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace poissonlab {
namespace {

/// A shape's word, and what is to follow it.
struct ShapeWord
{
    SpaceShape shape;
    std::string_view word;
    std::size_t numbers;
    const char* form;
};

constexpr std::array shape_words{
    ShapeWord{SpaceShape::box, "box ", 6, "box X0 Y0 Z0 X1 Y1 Z1 with X0 < X1, Y0 < Y1 and Z0 < Z1"},
    ShapeWord{SpaceShape::ball, "ball ", 4, "ball X Y Z RADIUS with RADIUS > 0"},
    ShapeWord{SpaceShape::solid, "solid ", 6,
              "solid X0 Y0 Z0 X1 Y1 Z1 EXPRESSION with X0 < X1, Y0 < Y1, Z0 < Z1 and an expression in x, y and z"}};

/// The word must be followed by a number: files may be called "ball park.geojson".
const ShapeWord* shape_word_of(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const auto found =
        std::ranges::find_if(shape_words, [&](const ShapeWord& shape) { return text.starts_with(shape.word); });
    if (found == shape_words.end()) return nullptr;
    WordReader words(text.substr(found->word.size()));
    double number = 0;
    return words.next() && parse_number(words.word(), number) ? &*found : nullptr;
}

/// The numbers after the first word, and where the rest begins: nothing where they are not all there.
std::optional<std::vector<double>> leading_numbers(const std::string& text, std::size_t count, std::string& rest)
{
    std::vector<double> numbers(count);
    if (mixes_separators(std::string_view(text).substr(std::min(text.size(), text.find(' '))), count, 3)) return {};
    WordReader words(text);
    words.next();
    for (double& number : numbers)
        if (!words.next() || !parse_number(words.word(), number) || !std::isfinite(number)) return {};
    if (words.next()) rest = text.substr(static_cast<std::size_t>(words.word().data() - text.data()));
    return numbers;
}

SpaceBox box_of_numbers(std::span<const double> n) { return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}}; }

SpaceBox box_around_ball(std::span<const double> n)
{
    SpaceBox box;
    for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = n[k] - n[3];
        box.high[k] = n[k] + n[3];
    }
    return box;
}

bool has_room(const SpaceBox& box)
{
    return box.extent(0) > 0 && box.extent(1) > 0 && box.extent(2) > 0 && std::isfinite(box.longest());
}

}

double SpaceBox::longest() const { return std::max({extent(0), extent(1), extent(2)}); }

bool is_space_region_text(std::string_view text) { return shape_word_of(text) != nullptr; }

bool is_mesh_name(std::string_view name)
{
    std::string end(name.substr(std::min(name.rfind('.'), name.size())));
    for (char& c : end)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    constexpr std::array<std::string_view, 6> ends{".obj", ".ply", ".off", ".stl", ".gltf", ".glb"};
    return std::ranges::find(ends, end) != ends.end();
}

SpaceRegion read_space_region(const std::string& text)
{
    const ShapeWord* shape = shape_word_of(text);
    SpaceRegion region{shape->shape, {}};
    const auto numbers = leading_numbers(text, shape->numbers, region.formula);
    if (numbers) region.box = shape->shape == SpaceShape::ball ? box_around_ball(*numbers) : box_of_numbers(*numbers);
    if (!numbers || !has_room(region.box) || region.formula.empty() == (shape->shape == SpaceShape::solid))
        throw InputError(
            fmt::format("{}: must be {}{}", shortened(printable(text)), shape->form, decimal_comma_words(text)));
    return region;
}

double distance_rounding(double distance, const SpaceBox& box)
{
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) largest = std::max({largest, std::abs(box.low[k]), std::abs(box.high[k])});
    return 4 * largest * std::numeric_limits<double>::epsilon() + distance * 0x1p-50;
}

}
