// kind = "icons": arrows of a vector field.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.4.
#include "base/files/whole_file.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/icons.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr WordTable<bool, 2> icon_lengths{{{{false, "magnitude"}, {true, "one"}}}};

void icon_keys(Keys& keys, IconSettings& s)
{
    keys.file("field", s.field, "a picture whose first two channels are the vectors");
    keys.text("u", s.u, "the vectors to the right, a formula in x and y from -1 to 1").excludes("field");
    keys.text("v", s.v, "the vectors upwards, a formula").excludes("field");
    keys.points(s.points);
    keys.even_points(s.method);
    keys.word("length", s.have_one_length, icon_lengths, "how long arrows are: as their vectors, or all the same");
    if (keys.is_read() && s.field.empty() && (s.u.empty() || s.v.empty()))
        throw keys.problem(
            fmt::format("needs {}, or {} and {}", keys.name_of("field"), keys.name_of("u"), keys.name_of("v")));
    keys.check("u", [&] { formula_values(s.u, 1, 1); });
    keys.check("v", [&] { formula_values(s.v, 1, 1); });
}

std::string icon_label(const IconSettings& s)
{
    return s.field.empty() ? fmt::format("Icons of ({}, {})", shortened(s.u), shortened(s.v))
                           : fmt::format("Icons of {}", shortened(printable(s.field.filename().string())));
}

DistributionResult make_icons(const IconSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              DistributionFiles& files)
{
    const VectorField field = read_field(settings);
    const SquarePoints points =
        even_points(chosen_method(settings.method), settings.points, field.u.width, field.u.height, seed, place);
    const Icons icons = icons_at(points, field, settings.have_one_length);

    DistributionResult result;
    result.facts = {fmt::format("{} x {} pixels", field.u.width, field.u.height),
                    fmt::format("{} icons", icons.icons.size()), method_words(settings.method)};
    if (icons.holes > 0) result.facts.push_back(fmt::format("{} points in holes", icons.holes));
    files.add_marks("icons.json", icon_picture(icons, field), "Arrows, each in its disk; vectors too short are dots.",
                    result);
    write_whole_file(files.add("icons.csv", result), icons_csv(icons));
    result.numbers = icon_numbers(icons, field, points.size() / 2);
    return result;
}

}

DistributionNumbers icon_numbers(const Icons& icons, const VectorField& field, std::size_t points)
{
    DistributionNumbers numbers;
    const double radius = static_cast<double>(icons.radius) / static_cast<double>(icon_units);
    const double longest = std::max(field.u.width, field.u.height);
    const double area = field.u.width / longest * (field.u.height / longest);
    numbers.push_back({"disk_radius", "Disk radius", radius, "of the longest side: no arrow leaves its disk"});
    numbers.push_back({"relative_radius", "Relative radius",
                       2 * radius * std::sqrt(static_cast<double>(points) * std::numbers::sqrt3 / 2 / area),
                       "least distance of two points, 1 for the densest packing: how large arrows can be"});
    return numbers;
}

Kind icon_kind()
{
    return make_kind<IconSettings>(
        {"distribution", "icons", "distribute icons", "Icons", "Show a vector field by arrows that do not overlap"},
        icon_keys, icon_label, make_icons);
}

}
