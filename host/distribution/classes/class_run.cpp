// kind = "classes": points of several classes, each and all together even.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "host/distribution/classes/class_density.hpp"
#include "host/distribution/classes/class_files.hpp"
#include "host/distribution/classes/class_lines.hpp"
#include "host/distribution/classes/class_lists.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_points.hpp"
#include "host/distribution/classes/class_tiling.hpp"
#include "host/distribution/region_runs/region_results.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/keys/class_keys.hpp"
#include "host/settings/keys/region_keys.hpp"
#include "host/settings/sampler_table.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// Returns whether points are those of a tiling, to which the other keys do not apply.
bool has_tiles(const Keys& keys)
{
    const bool has_tiles = keys.is_given("tiles");
    if (!has_tiles && !keys.is_given("colors") && keys.is_given("torus"))
        throw keys.invalid("torus", fmt::format("needs {} or {}", keys.name_of("tiles"), keys.name_of("colors")));
    for (const char* key :
         {"points", "distances", "matrix", "relative_radius", "factor", "dimension", "colors", "joint_iterations",
          "equal_moments", "densities", "densities_from", "feature_points", "feature_densities", "per_length"})
        if (has_tiles && keys.is_given(key))
            throw keys.invalid(key, "cannot be combined with " + keys.name_of("tiles"));
    for (const char* key : {"joint_iterations", "equal_moments"})
        if (keys.is_given(key) && !keys.is_given("colors")) throw keys.invalid(key, "needs " + keys.name_of("colors"));
    return has_tiles;
}

/// Says what is wrong with the set at its key, and what is wrong with densities at theirs.
void check_darts(const Keys& keys, const std::string& key, const ClassSettings& s)
{
    std::string wrong_density;
    keys.check(key, [&] {
        try {
            check_densities(class_work(s, 0));
        } catch (const DensityError& error) {
            wrong_density = error.what();
        }
    });
    if (!wrong_density.empty()) keys.check("densities", [&] { throw InputError(wrong_density); });
}

/// Reads the keys of a region. With a region, keys of the torus are refused.
void place_keys(Keys& keys, ClassSettings& s)
{
    keys.region("region", s.place.region, "the region that points lie in: a file, a formula, or a shape")
        .otherwise("the unit torus");
    region_reading_keys(keys, s.place.reading);
    keys.flag("along", s.place.reading.is_along,
              "whether points lie on the region's lines and outlines, at distances through the plane");
    obstacle_keys(keys, s.place.obstacles, s.place.obstacle_distance, "0");
    if (!keys.is_read()) return;
    for (const char* key : {"along", "planar", "crs", "overlap", "buffer", "obstacles"})
        if (!s.has_region() && keys.is_given(key)) throw keys.invalid(key, "needs " + keys.name_of("region"));
    if (!s.has_region()) return;
    for (const char* key : {"dimension", "colors", "joint_iterations", "equal_moments", "sets", "tiles", "torus"})
        if (keys.is_given(key)) throw keys.invalid(key, "cannot be combined with " + keys.name_of("region"));
    if (s.place.is_in_space()) throw keys.invalid("region", "must be a region of the plane, and this one is of space");
    for (const char* key : {"overlap", "buffer", "densities", "densities_from", "feature_points", "feature_densities"})
        if (s.is_along() && keys.is_given(key))
            throw keys.invalid(key, "cannot be combined with " + keys.name_of("along"));
    keys.check("region", [&] { read_region(s.place.region, s.place.reading); });
    keys.check(s.place.obstacles.empty() ? "region" : "obstacles", [&] { s.place.land = region_land(s.place); });
    if (!s.place.obstacle_distance && !s.place.land->obstacles.points.empty())
        throw keys.invalid("obstacles", "has points, which need " + keys.name_of("obstacle_distance"));
}

/// Reads what says how dense classes are, in places and in features.
void density_keys(Keys& keys, ClassSettings& s)
{
    class_density_keys(keys, s,
                       "the density of each class in the region, in any unit: a picture over its box, or a formula in "
                       "its x and y");
    names_of_classes(keys, "feature_points", s.features.points,
                     "the property of the region's features that says how many points of the class they have, one of "
                     "each class")
        .excludes("points")
        .otherwise("points");
    names_of_classes(keys, "feature_densities", s.features.densities,
                     "the property of the region's features that says how many points of the class they have in a "
                     "unit of area, one of each class")
        .excludes("feature_points")
        .otherwise("points");
}

/// Refuses densities and features without what they need.
void check_densities(const Keys& keys, const ClassSettings& s)
{
    for (const char* key : {"densities", "feature_points", "feature_densities"})
        if (keys.is_given(key) && !s.has_region()) throw keys.invalid(key, "needs " + keys.name_of("region"));
    if (keys.is_given("feature_densities") && keys.is_given("points"))
        throw keys.invalid("feature_densities", "cannot be combined with " + keys.name_of("points"));
    if (!s.features.is_empty() && s.place.reading.buffer > 0)
        throw keys.invalid("buffer", "cannot be combined with numbers of features");
    if (keys.is_given("densities_from") && s.densities.empty())
        throw keys.invalid("densities_from", "needs " + keys.name_of("densities"));
    if (!s.densities.empty() && !s.has_numbers())
        throw keys.invalid("densities", fmt::format("needs {}, {} or {}", keys.name_of("points"),
                                                    keys.name_of("feature_points"), keys.name_of("feature_densities")));
    const auto check_count = [&](const char* key, std::size_t count) {
        if (keys.is_given(key) && count != s.classes())
            throw keys.invalid(key, fmt::format("must be {}, one of each class", s.classes()));
    };
    check_count("densities", s.densities.size());
    if (s.densities_from.size() > 1) check_count("densities_from", s.densities_from.size());
    check_count("feature_points", s.features.points.size());
    check_count("feature_densities", s.features.densities.size());
}

/// Reads how many points classes have on a unit of length, and makes numbers of points of it.
void number_keys_of_lines(Keys& keys, ClassSettings& s)
{
    class_list(keys, "per_length", s.per_length, {1e-12, 1e12}, "a number from 1e-12 to 1e12",
               "with along: how many points of the class lie on a unit of length of the lines, on average")
        .unit("1 / unit of the region")
        .excludes("points")
        .otherwise("points");
    if (!keys.is_read() || !keys.is_given("per_length")) return;
    if (!s.is_along()) throw keys.invalid("per_length", "needs " + keys.name_of("along"));
    keys.check("per_length", [&] { s.points = points_on_lines(s); });
}

void class_keys(Keys& keys, ClassSettings& s)
{
    place_keys(keys, s);
    // In regions distances are lengths of any size, and otherwise parts of the torus.
    const Interval lengths = s.has_region() ? Interval{1e-12, 1e12} : Interval{1e-6, 1};
    class_list_keys(keys, s, lengths, "sides of the torus; with region, in its units and up to 1e12");
    number_keys_of_lines(keys, s);
    density_keys(keys, s);
    keys.number("factor", s.factor, {0.5, 0.9999},
                "what all distances are multiplied by where a class has no room for its points: relaxation")
        .otherwise("distances stay");
    keys.integer("dimension", s.dimension, 2, 3, "of the torus: a square or a cube");
    keys.integer("colors", s.colors, 1, 16,
                 "corner tiles of so many colors are built: points are those of a tile, distances in tiles")
        .otherwise("no tiles are built");
    keys.integer("joint_iterations", s.joint_iterations, 0, 100000,
                 "with colors: how often all tiles are relaxed together, and the mean tile is made even");
    keys.integer("equal_moments", s.equal_moments, 0, 2,
                 "with colors: the order up to which the points of each class have the same moments in all tiles");
    keys.integer("sets", s.sets, 1, 1000, "sets whose spectra are averaged; points are those of the first");
    keys.tiles(s.tiles).otherwise("darts are thrown");
    keys.integer("torus", s.torus, 1, 4096, "with tiles or colors: so many along each axis, whose opposite edges fit");
    if (keys.is_read() && s.sets > 1 && s.dimension != 2)
        throw keys.invalid("sets", "is about spectra, which are of the plane: dimension 2");
    if (!keys.is_read() || has_tiles(keys)) return;
    check_class_lists(keys, s);
    check_densities(keys, s);
    if (keys.is_given("factor") && (!s.has_numbers() || s.colors > 0))
        throw keys.invalid("factor",
                           fmt::format("needs {}, without {}", keys.name_of("points"), keys.name_of("colors")));
    if (s.colors > 0 && s.points.empty()) throw keys.problem("needs " + keys.name_of("points") + ", of each tile");
    if (s.colors > 0 && s.dimension != 2) throw keys.invalid("dimension", "must be 2 for tiles");
    const std::string key = !s.per_length.empty()           ? "per_length"
                            : !s.points.empty()             ? "points"
                            : !s.features.points.empty()    ? "feature_points"
                            : !s.features.densities.empty() ? "feature_densities"
                            : s.matrix.empty()              ? "distances"
                                                            : "matrix";
    if (s.colors > 0) return keys.check(key, [&] { check(class_tile_parameters(s, 0)); });
    check_darts(keys, key, s);
}

std::string class_label(const ClassSettings& s)
{
    if (!s.tiles.empty())
        return fmt::format("classes of {0}, {1} x {1} tiles", name_of_input(s.tiles.string()), s.torus);
    if (s.colors > 0)
        return fmt::format("classes of {0} x {0} corner tiles of {1} points{2}{3}", s.torus, fmt::join(s.points, ", "),
                           s.joint_iterations > 0 ? fmt::format(", relaxed {} times", s.joint_iterations) : "",
                           s.equal_moments > 0 ? fmt::format(", equal moments {}", s.equal_moments) : "");
    const std::string where = s.has_region() ? (s.is_along() ? " along " : " in ") + name_of_input(s.place.region) : "";
    if (!s.features.is_empty()) return fmt::format("{} classes{}, by features", s.classes(), where);
    return s.points.empty() ? fmt::format("{} classes{}, saturated", s.classes(), where)
                            : fmt::format("{} classes{}, {} points", s.classes(), where, fmt::join(s.points, ", "));
}

std::vector<std::string> facts_of(const ClassSettings& s)
{
    if (!s.tiles.empty())
        return {fmt::format("a torus of {0} x {0} tiles of {1}", s.torus, name_of_input(s.tiles.string())),
                "distances of pairs proven for every tiling"};
    if (s.colors > 0)
        return {fmt::format("a torus of {0} x {0} corner tiles over {1} colors", s.torus, s.colors),
                "distances of pairs proven for every tiling"};
    return {!s.has_numbers()  ? "saturated: no further point of any class fits"
            : s.factor == 1.0 ? "as many of each class as asked for"
                              : fmt::format("distances multiplied by {} until there is room for all", s.factor),
            s.matrix.empty() ? "distances of pairs by Wei's matrix" : "distances of pairs as given"};
}

DistributionResult make_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files)
{
    const ClassSet set = throw_classes(settings, seed, place);
    const ClassedPoints in_files = set.as_in_files();
    DistributionResult result;
    result.facts = {fmt::format("{} classes", set.work.asked.classes()),
                    fmt::format("{} points", set.points.points.size())};
    for (const std::string& fact : facts_of(settings)) result.facts.push_back(fact);
    files.add_marks("points.json", class_picture(set),
                    settings.dimension == 2 ? "The points, a colour for each class."
                                            : "The points of the lowest tenth, a colour for each class.",
                    result);
    for (const char* name : {"points.csv", "points.ply"}) {
        write_class_file(files.add(name), in_files, "", set.region());
        result.files.emplace_back(name);
    }
    write_points(files.add("points.npy"), in_files.points);
    write_class_numbers(files.add("classes.npy"), set.points.classes);
    for (const char* name : {"points.npy", "classes.npy"}) result.files.emplace_back(name);
    if (settings.colors > 0) {
        write_tile_set(files.add("tiles.ptiles"), *set.tiles);
        result.files.emplace_back("tiles.ptiles");
    }
    if (set.work.land) {
        for (const std::string& note : notes_of(set.work.land->whole)) result.facts.push_back(note);
        for (const std::string& note : density_notes(set)) result.facts.push_back(note);
        if (set.is_on_lines())
            result.facts.push_back(fmt::format("lines of {:.6g}, without what is too near to obstacles", set.size()));
        else
            add_region_curves(set.work.land->rest, set.in_units().points, files, result);
    } else if (settings.dimension == 2)
        add_class_spectra(set.points.points.size(), averaged_spectra(settings, seed, place, set), {}, files, result);
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
