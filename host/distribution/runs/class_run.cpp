// kind = "classes": points of several classes, each and all together even.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "host/distribution/classes/class_files.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_points.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// The numbers of a list, whose lists count as their numbers, or of a single number; nothing where there is another
/// value.
std::optional<std::vector<double>> numbers_in(const ConfigNode& node)
{
    if (const auto* whole = node.get_if<std::int64_t>()) return std::vector{static_cast<double>(*whole)};
    if (const auto* real = node.get_if<double>()) return std::vector{*real};
    const auto* items = node.get_if<ConfigList>();
    if (!items) return {};
    std::vector<double> all;
    for (const ConfigNode& item : *items) {
        const auto some = numbers_in(item);
        if (!some) return {};
        all.insert(all.end(), some->begin(), some->end());
    }
    return all;
}

/// Numbers of classes from `low` to `high`, as many as classes at most.
Keys::Said class_list(Keys& keys, const std::string& key, std::vector<double>& values, Interval range,
                      const std::string& each, std::string help)
{
    const std::string allowed = fmt::format("{} of each class, at most {} of them", each, most_classes);
    return keys
        .value(key, allowed, std::move(help),
               [&](const ConfigNode& node) {
                   values = numbers_in(node).value_or(std::vector<double>{});
                   const auto is_allowed = [&](double v) { return v >= range.low && v <= range.high; };
                   if (values.empty() || values.size() > most_classes || !std::ranges::all_of(values, is_allowed))
                       throw keys.invalid(key, "must be " + allowed);
               })
        .at_most(most_classes);
}

void matrix_key(Keys& keys, ClassSettings& s)
{
    const std::string allowed = "rows of numbers from 1e-06 to 1, as many as classes, the same as columns";
    keys.value("matrix", allowed, "the least distance of points of each pair of classes",
               [&](const ConfigNode& node) {
                   s.matrix = numbers_in(node).value_or(std::vector<double>{});
                   const std::size_t n = s.classes();
                   bool is_allowed = !s.matrix.empty() && n * n == s.matrix.size() && n <= most_classes;
                   for (std::size_t i = 0; is_allowed && i < n * n; ++i)
                       is_allowed =
                           s.matrix[i] >= 1e-6 && s.matrix[i] <= 1 && s.matrix[i] == s.matrix[i % n * n + i / n];
                   if (!is_allowed) throw keys.invalid("matrix", "must be " + allowed);
               })
        .at_most(most_classes * most_classes)
        .excludes("distances")
        .otherwise("that of Wei 2010, from distances");
}

void class_keys(Keys& keys, ClassSettings& s)
{
    std::vector<double> points;
    class_list(keys, "points", points, {1, static_cast<double>(max_points)}, "a whole number from 1",
               "how many points there are")
        .otherwise("as many as there is room for");
    for (const double count : points) {
        if (count != std::floor(count)) throw keys.invalid("points", "must be whole numbers");
        s.points.push_back(static_cast<std::size_t>(count));
    }
    class_list(keys, "distances", s.distances, {1e-6, 1}, "a number from 1e-06 to 1",
               "the least distance of points of the same class")
        .unit("sides of the torus")
        .otherwise("those of relative_radius");
    matrix_key(keys, s);
    keys.number("relative_radius", s.relative_radius, {0.001, 1},
                "of each class: its distance over that of the densest packing of as many points")
        .excludes("distances");
    keys.integer("dimension", s.dimension, 2, 3, "of the torus: a square or a cube");
    if (!keys.is_read()) return;
    if (keys.is_given("relative_radius") && !s.matrix.empty())
        throw keys.invalid("relative_radius", "does not go with " + keys.name_of("matrix"));
    if (s.points.empty() && s.distances.empty() && s.matrix.empty())
        throw keys.problem(fmt::format("needs {}, {} or {}", keys.name_of("points"), keys.name_of("distances"),
                                       keys.name_of("matrix")));
    if (keys.is_given("relative_radius") && s.points.empty())
        throw keys.invalid("relative_radius", "goes with " + keys.name_of("points"));
    if (!s.points.empty() && s.points.size() != s.classes())
        throw keys.invalid("points", fmt::format("must be {}, one of each class", s.classes()));
    if (!s.points.empty() && !s.distances.empty() && s.distances.size() != s.points.size())
        throw keys.invalid("distances", fmt::format("must be {}, one of each class", s.points.size()));
    keys.check(!s.points.empty()  ? "points"
               : s.matrix.empty() ? "distances"
                                  : "matrix",
               [&] { class_dart_request(s, 0); });
}

std::string class_label(const ClassSettings& s)
{
    return s.points.empty() ? fmt::format("{} classes, saturated", s.classes())
                            : fmt::format("{} classes, {} points", s.classes(), fmt::join(s.points, ", "));
}

DistributionResult make_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files)
{
    const ClassSet set = throw_classes(settings, seed, place);
    DistributionResult result;
    result.facts = {fmt::format("{} classes", settings.classes()), fmt::format("{} points", set.points.points.size()),
                    settings.points.empty() ? "saturated: no further point of any class fits"
                                            : "as many of each class as asked for",
                    settings.matrix.empty() ? "distances of pairs by Wei's matrix" : "distances of pairs as given"};
    files.add_marks("points.json", class_picture(set.points, set.request.distances),
                    settings.dimension == 2 ? "The points, a colour for each class."
                                            : "The points of the lowest tenth, a colour for each class.",
                    result);
    for (const char* name : {"points.csv", "points.ply"}) {
        write_class_file(files.add(name), set.points, "");
        result.files.emplace_back(name);
    }
    write_points(files.add("points.npy"), set.points.points);
    write_class_numbers(files.add("classes.npy"), set.points);
    for (const char* name : {"points.npy", "classes.npy"}) result.files.emplace_back(name);
    if (settings.dimension == 2) {
        const CrossSpectra spectra = class_spectra(set.points);
        files.add_marks("power.json", power_picture(set.points, spectra),
                        "Radially averaged power of each class and of all points, of this set alone.", result);
        if (!spectra.cross.empty())
            files.add_marks(
                "cross-power.json", cross_picture(set.points, spectra),
                "Cross power of pairs of classes: 0 where they know nothing of each other, below 0 where one "
                "has its points between those of the other.",
                result);
        write_whole_file(files.add("spectra.csv"), spectra_csv(set.points, spectra));
        result.files.push_back("spectra.csv");
    }
    result.numbers = class_numbers(set);
    result.tables.push_back(distance_table(set));
    return result;
}

}

Kind class_kind()
{
    return make_kind<ClassSettings>({"distribution", "classes", "distribute classes", "Classes of points",
                                     "Throw darts of several classes, each and all together even"},
                                    class_keys, class_label, make_classes);
}

}
