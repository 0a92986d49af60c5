#include "host/distribution/icons.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr std::int64_t radii_a_width = 6; ///< of strokes
constexpr double longest_vector = 1e150;  ///< whose square is a number
constexpr double head_back = 0.5;         ///< where an arrow's head ends, in parts of half its length
constexpr double head_aside = 0.3;

double length_of(const std::array<double, 2>& vector)
{
    // Squares and roots are rounded alike everywhere.
    return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1]);
}

std::size_t pixel_at(std::uint32_t part, int pixels)
{
    return static_cast<std::size_t>(std::uint64_t{part} * static_cast<std::uint64_t>(pixels) >> 32);
}

std::int64_t floor_root(std::uint64_t square)
{
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(square)));
    while (root * root > square) --root;
    while ((root + 1) * (root + 1) <= square) ++root;
    return static_cast<std::int64_t>(root);
}

/// An arrow through its place, from one end of its disk to the other where `part` is 1.
std::vector<std::array<IconPoint, 2>> arrow(const std::array<double, 2>& vector, double part, std::int64_t radius,
                                            std::int64_t width)
{
    // Rounding an end moves it by less than a unit.
    const double reach = static_cast<double>(radius - width / 2 - 2) * part;
    if (reach <= static_cast<double>(width) / 2) return {};
    const double length = length_of(vector), x = vector[0] / length, y = vector[1] / length;
    const auto at = [&](double along, double aside) {
        return IconPoint{std::llround(reach * (along * x - aside * y)), std::llround(reach * (along * y + aside * x))};
    };
    const IconPoint tip = at(1, 0);
    return {{at(-1, 0), tip}, {at(head_back, head_aside), tip}, {at(head_back, -head_aside), tip}};
}

/// The first two channels of a picture. What is transparent is a hole.
VectorField field_of_picture(const std::string& file)
{
    const LinearPicture picture = read_linear_picture(file);
    if (picture.channels.size() < (picture.alpha ? 3 : 2))
        throw InputError(
            fmt::format("{}: has one channel{}; a field needs two", file, picture.alpha ? " beside alpha" : ""));
    VectorField field{picture_values(picture, picture.channels[0], file),
                      picture_values(picture, picture.channels[1], file)};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
            if (cover_at(picture, column, row) == 0)
                field.u.values[static_cast<std::size_t>(picture.height - 1 - row) *
                                   static_cast<std::size_t>(picture.width) +
                               static_cast<std::size_t>(column)] = std::numeric_limits<double>::quiet_NaN();
    return field;
}

}

VectorField read_field(const IconSettings& settings)
{
    VectorField field;
    if (settings.field.empty()) {
        field = {formula_values(settings.u, 1, 1), formula_values(settings.v, 1, 1)};
    } else {
        field = field_of_picture(settings.field.string());
    }
    bool has_vectors = false;
    for (std::size_t i = 0; i < field.u.values.size(); ++i) {
        const double u = field.u.values[i], v = field.v.values[i];
        if (std::abs(u) > longest_vector || std::abs(v) > longest_vector)
            throw InputError(fmt::format("the field at {} is ({}, {}): must be numbers up to {}, or not a number for a "
                                         "hole",
                                         pixel_name(field.u.width, field.u.height, i), u, v, longest_vector));
        has_vectors = has_vectors || u * u + v * v > 0;
    }
    if (!has_vectors) throw InputError("the field has no vectors: is 0 or a hole everywhere");
    return field;
}

std::uint64_t least_squared_distance(std::vector<IconPoint> places)
{
    std::ranges::sort(places);
    auto least = places.size() < 2 ? std::uint64_t{0} : std::numeric_limits<std::uint64_t>::max();
    const auto squared = [](std::int64_t number) {
        const auto size = static_cast<std::uint64_t>(number < 0 ? -number : number);
        return size * size;
    };
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = i + 1; k < places.size(); ++k) {
            const std::uint64_t along = squared(places[k][0] - places[i][0]);
            if (along >= least) break;
            least = std::min(least, along + squared(places[k][1] - places[i][1]));
        }
    return least;
}

Icons icons_at(const SquarePoints& points, const VectorField& field, bool have_one_length)
{
    const int width = field.u.width, height = field.u.height, longest = std::max(width, height);
    const auto side = [&](std::uint32_t part, int pixels) {
        return static_cast<std::int64_t>(part) * pixels / longest / 4; // 2^32 parts, 2^30 units
    };
    Icons icons;
    std::vector<IconPoint> places;
    double most = 0;
    for (std::size_t i = 0; i < points.size(); i += 2) {
        places.push_back({side(points[i], width), side(points[i + 1], height)});
        const std::size_t pixel =
            pixel_at(points[i + 1], height) * static_cast<std::size_t>(width) + pixel_at(points[i], width);
        const std::array<double, 2> vector{field.u.values[pixel], field.v.values[pixel]};
        if (std::isnan(vector[0]) || std::isnan(vector[1])) {
            ++icons.holes;
            continue;
        }
        most = std::max(most, length_of(vector));
        icons.icons.push_back({places.back(), vector, {}});
    }
    // Disks are those of all points, holes too; one icon alone has the whole field.
    icons.radius = places.size() < 2 ? icon_units / 2 : floor_root(least_squared_distance(places)) / 2;
    icons.width = icons.radius / radii_a_width;
    for (Icon& icon : icons.icons) {
        const double length = length_of(icon.vector);
        if (length > 0)
            icon.strokes = arrow(icon.vector, have_one_length ? 1 : length / most, icons.radius, icons.width);
    }
    return icons;
}

MarkPicture icon_picture(const Icons& icons, const VectorField& field)
{
    const double longest = std::max(field.u.width, field.u.height);
    const auto units = [&](std::int64_t number) {
        return static_cast<double>(number) / static_cast<double>(icon_units);
    };
    const double room = units(icons.radius);
    MarkPicture picture;
    picture.width = field.u.width / longest + 2 * room;
    picture.height = field.u.height / longest + 2 * room;
    MarkGroup arrows{"#1356a2"}, dots{"#1356a2"};
    for (const Icon& icon : icons.icons) {
        const double x = units(icon.place[0]) + room, y = units(icon.place[1]) + room;
        if (icon.strokes.empty()) dots.disks.push_back({x, y, units(icons.width) / 2});
        for (const auto& [from, to] : icon.strokes)
            arrows.strokes.push_back(
                {x + units(from[0]), y + units(from[1]), x + units(to[0]), y + units(to[1]), units(icons.width)});
    }
    picture.groups = {std::move(arrows), std::move(dots)};
    return picture;
}

std::string icons_csv(const Icons& icons)
{
    std::string text = "x,y,u,v\n";
    for (const Icon& icon : icons.icons)
        text += fmt::format("{},{},{},{}\n", static_cast<double>(icon.place[0]) / static_cast<double>(icon_units),
                            static_cast<double>(icon.place[1]) / static_cast<double>(icon_units), icon.vector[0],
                            icon.vector[1]);
    return text;
}

}
