#include "host/distribution/classes/class_lists.hpp"

#include "host/settings/keys/class_keys.hpp"
#include "host/settings/sampler_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

void class_list_keys(Keys& keys, ClassSettings& s, const Interval& lengths, const std::string& unit)
{
    class_counts(keys, "points", s.points, max_points, "how many points there are")
        .otherwise("as many as there is room for");
    class_list(keys, "distances", s.distances, lengths,
               fmt::format("a number from {:g} to {:g}", lengths.low, lengths.high),
               "the least distance of points of the same class")
        .unit(unit)
        .otherwise("those of relative_radius");
    class_matrix(keys, "matrix", s.matrix, lengths)
        .unit(unit)
        .excludes("distances")
        .otherwise("that of Wei 2010, from distances");
    keys.number("relative_radius", s.relative_radius, {0.001, 1},
                "of each class: its distance over that of the densest packing of as many points")
        .excludes("distances");
}

void check_class_lists(const Keys& keys, const ClassSettings& s)
{
    if (keys.is_given("relative_radius") && !s.matrix.empty())
        throw keys.invalid("relative_radius", "cannot be combined with " + keys.name_of("matrix"));
    if (!s.has_numbers() && s.distances.empty() && s.matrix.empty())
        throw keys.problem(fmt::format("needs {}, {} or {}", keys.name_of("points"), keys.name_of("distances"),
                                       keys.name_of("matrix")));
    if (keys.is_given("relative_radius") && !s.has_numbers())
        throw keys.invalid("relative_radius", "needs " + keys.name_of("points"));
    if (!s.points.empty() && s.points.size() != s.classes())
        throw keys.invalid(s.per_length.empty() ? "points" : "per_length",
                           fmt::format("must be {}, one of each class", s.classes()));
    if (s.has_numbers() && !s.distances.empty())
        if (const std::size_t classes = std::max(s.points.size(), s.features.names().size());
            s.distances.size() != classes)
            throw keys.invalid("distances", fmt::format("must be {}, one of each class", classes));
}

Keys::Said names_of_classes(Keys& keys, const std::string& key, std::vector<std::string>& values,
                            const std::string& help)
{
    KeySpec spec{.value = {.key = key, .kind = ParameterSpec::Kind::text, .help = help},
                 .count = most_classes,
                 .own = "a list of names in quotes"};
    return keys.texts(std::move(spec), values, "names in quotes, one of each class");
}

void class_density_keys(Keys& keys, ClassSettings& s, const std::string& help)
{
    KeySpec spec{.value = {.key = "densities", .kind = ParameterSpec::Kind::text, .help = help},
                 .count = most_classes,
                 .is_file = true,
                 .is_formula = true,
                 .own = "a list of pictures' files and formulas in quotes"};
    keys.texts(std::move(spec), s.densities, "pictures' files or formulas in quotes, one of each class")
        .otherwise("classes are as dense everywhere");
    names_of_classes(keys, "densities_from", s.densities_from,
                     "what is read of the pictures of densities: light, ink, or one of their channels; one for all, "
                     "or one of each class")
        .otherwise("light");
}

}
