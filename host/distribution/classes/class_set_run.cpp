// kind = "class-set" measures points with classes, wherever they come from.
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/points/point_file.hpp"
#include "base/text/csv_fields.hpp"
#include "host/distribution/classes/class_pictures.hpp"
#include "host/distribution/classes/class_set.hpp"
#include "host/distribution/region_runs/dart_pictures.hpp"
#include "host/kinds/kinds.hpp"
#include "host/settings/keys/region_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Pages list the numbers of up to this many classes one by one; numbers of more classes are in the tables alone.
constexpr std::size_t most_numbered_classes = 8;

/// A picture has room for the curves of this many pairs.
constexpr std::size_t most_pairs_shown = 18;

void class_set_keys(Keys& keys, ClassSetSettings& s)
{
    keys.file("set", s.set, "the points: a file of points with classes, in the region's coordinates if there is one")
        .required();
    keys.text(
        "classes", s.classes,
        "the column, or the property of PLY and GeoJSON, that has the class of each point: its name, or its number "
        "where columns have no names");
    keys.region("region", s.region, "the region that points lie in: a file, a formula, or a shape")
        .otherwise("a torus");
    region_reading_keys(keys, s.reading);
    keys.text("domain", s.domain, "the range of coordinates, such as \"0:512\" or \"0:2 0:1\"; without window, a torus")
        .excludes("region")
        .otherwise("what the file says, or 0:1");
    keys.flag("window", s.window, "whether the domain is a region whose opposite sides do not meet").excludes("region");
    keys.number("reach", s.reach, {1e-12, 1e12}, "the distance up to which curves are measured")
        .unit("units of the points")
        .otherwise("four times the distance of the densest packing of as many points");
    keys.integer("labellings", s.labellings, 0, 999,
                 "random permutations of the classes that the mark correlation is compared with");
    if (!keys.is_read()) return;
    for (const char* key : region_reading_names)
        if (s.region.empty() && keys.is_given(key)) throw keys.invalid(key, "needs " + keys.name_of("region"));
    if (s.classes.empty()) throw keys.invalid("classes", "must be the name or the number of a column");
    if (!s.domain.empty() && !parse_domain(s.domain))
        throw keys.invalid("domain", fmt::format("must be {}", domain_form));
    keys.check("set", [&] { s.read = read_class_set(s); });
}

std::string class_set_label(const ClassSetSettings& s) { return "classes of " + s.set.stem().string(); }

/// The classes of a pair in words.
std::string pair_name(const ClassSetPoints& set, const ClassPairMeasures& pair)
{
    return fmt::format("{} and {}", set.names[pair.first], set.names[pair.second]);
}

/// The mean distance of points from the nearest of `count` others, over the mean for independent points.
double over_random(double mean, std::size_t count, double area)
{
    return 2 * mean * std::sqrt(static_cast<double>(count) / area);
}

/// The area, in squares of the units of the points.
double area_in_units(const ClassSetPoints& set) { return set.region ? set.region->own_area() : set.unit * set.unit; }

std::string cell_of(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string("–"); }

DistributionTable table_of_classes(const ClassSetPoints& set, const ClassSetMeasures& measures,
                                   const std::vector<std::size_t>& counts)
{
    DistributionTable table{"Classes, each alone and all together",
                            {"class", "points", "share", "least distance", "mean nearest distance",
                             "over that of random points", "relative radius"},
                            {}};
    const auto add = [&](const std::string& name, std::size_t count, const ClassPairMeasures& own) {
        const double area = area_in_units(set), packed = max_min_distance(count, 2) * std::sqrt(area);
        const double share = 100 * static_cast<double>(count) / static_cast<double>(set.points.size());
        table.rows.push_back({name, std::to_string(count), fmt::format("{:.3g} %", share), cell_of(own.least),
                              cell_of(own.mean_first), cell_of(over_random(own.mean_first, count, area)),
                              cell_of(own.least / packed)});
    };
    for (std::size_t i = 0; i < counts.size(); ++i) add(set.names[i], counts[i], measures.own[i]);
    add("all", set.points.size(), measures.all);
    return table;
}

DistributionTable table_of_pairs(const ClassSetPoints& set, const ClassSetMeasures& measures,
                                 const std::vector<std::size_t>& counts)
{
    DistributionTable table{"Pairs of classes: distances of points of one class from the nearest point of the other",
                            {"first", "second", "least distance", "mean nearest, first to second",
                             "over independent classes", "mean nearest, second to first", "over independent classes"},
                            {}};
    const double area = area_in_units(set);
    for (const ClassPairMeasures& pair : measures.cross)
        table.rows.push_back(
            {set.names[pair.first], set.names[pair.second], cell_of(pair.least), cell_of(pair.mean_first),
             cell_of(over_random(pair.mean_first, counts[pair.second], area)), cell_of(pair.mean_second),
             cell_of(over_random(pair.mean_second, counts[pair.first], area))});
    return table;
}

DistributionNumbers class_set_numbers(const ClassSetPoints& set, const ClassSetMeasures& measures,
                                      const std::vector<std::size_t>& counts)
{
    DistributionNumbers numbers{{"points", "Points", static_cast<double>(set.points.size()), "of all classes"},
                                {"classes", "Classes", static_cast<double>(counts.size()), ""}};
    if (measures.labellings > 0)
        numbers.push_back({"labels_p_value", "P-value of random labelling", measures.marks.p_value,
                           fmt::format("the share of sets, {} with classes permuted at random and this one, whose mark "
                                       "correlation is at least as far from 1 as here",
                                       measures.labellings)});
    if (measures.covariance_error > 0)
        numbers.push_back({"covariance_error", "Error of areas in common", measures.covariance_error,
                           "of the region and the moved region, from a table, over the region's area"});
    if (counts.size() > most_numbered_classes) return numbers;
    const auto add = [&](const std::string& key, const std::string& title, double value) {
        if (std::isfinite(value)) numbers.push_back({key, title, value, "in units of the points", {}, true});
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        numbers.push_back({fmt::format("points_{}", i),
                           fmt::format("Points of {}", set.names[i]),
                           static_cast<double>(counts[i]),
                           "",
                           {},
                           true});
        add(fmt::format("least_{}", i), fmt::format("Least distance of {}", set.names[i]), measures.own[i].least);
        add(fmt::format("mean_nearest_{}", i), fmt::format("Mean nearest distance of {}", set.names[i]),
            measures.own[i].mean_first);
    }
    for (const ClassPairMeasures& pair : measures.cross) {
        const std::string &a = set.names[pair.first], &b = set.names[pair.second];
        add(fmt::format("least_{}_{}", pair.first, pair.second), fmt::format("Least distance of {} and {}", a, b),
            pair.least);
        add(fmt::format("mean_nearest_{}_{}", pair.first, pair.second),
            fmt::format("Mean distance of {} from the nearest {}", a, b), pair.mean_first);
        add(fmt::format("mean_nearest_{}_{}", pair.second, pair.first),
            fmt::format("Mean distance of {} from the nearest {}", b, a), pair.mean_second);
    }
    return numbers;
}

/// Makes a curve over distances in mean spacings of the `count` points that a pair has together.
ChartCurve curve_of_steps(const std::string& name, const std::string& color, const std::vector<double>& values,
                          const ClassDistanceSteps& steps, double spacing)
{
    ChartCurve curve{name, color, {}};
    for (std::size_t k = 0; k < values.size(); ++k)
        if (std::isfinite(values[k]))
            curve.places.push_back({steps.step * static_cast<double>(k + 1) / spacing, values[k]});
    return curve;
}

class ClassSetCharts
{
public:
    ClassSetCharts(const ClassSetPoints& set, const ClassSetMeasures& measures, const std::vector<std::size_t>& counts)
        : set_(set), measures_(measures), counts_(counts), area_(set.region ? set.region->area() : 1)
    {}

    CurveChart own() const
    {
        std::vector<ChartCurve> curves{curve(measures_.all, "all", "#000000", set_.points.size())};
        for (std::size_t i = 0; i < std::min(counts_.size(), most_pairs_shown); ++i)
            curves.push_back(curve(measures_.own[i], set_.names[i], class_color(i), counts_[i]));
        return chart(std::move(curves), "pair correlation g", 3);
    }

    CurveChart cross() const
    {
        std::vector<ChartCurve> curves;
        for (std::size_t i = 0; i < std::min(measures_.cross.size(), most_pairs_shown); ++i) {
            const ClassPairMeasures& pair = measures_.cross[i];
            curves.push_back(
                curve(pair, pair_name(set_, pair), class_color(i), counts_[pair.first] + counts_[pair.second]));
        }
        return chart(std::move(curves), "cross pair correlation g", 3);
    }

    CurveChart marks() const
    {
        const auto band = [&](const char* name, const std::vector<double>& values) {
            return curve_of_steps(name, "#8a8f98", values, measures_.all.steps, spacing(set_.points.size()));
        };
        std::vector<ChartCurve> curves;
        if (measures_.labellings > 0)
            curves = {band("least of random labellings", measures_.marks.low),
                      band("largest of random labellings", measures_.marks.high)};
        curves.push_back(curve_of_steps("points", "#2c728e", measures_.marks.values, measures_.all.steps,
                                        spacing(set_.points.size())));
        return chart(std::move(curves), "mark correlation", 3);
    }

private:
    double spacing(std::size_t points) const { return std::sqrt(area_ / static_cast<double>(points)); }

    ChartCurve curve(const ClassPairMeasures& pair, const std::string& name, const std::string& color,
                     std::size_t points) const
    {
        return curve_of_steps(name, color, pair.values, pair.steps, spacing(points));
    }

    static CurveChart chart(std::vector<ChartCurve> curves, const char* y, double high)
    {
        double farthest = 1;
        for (const ChartCurve& each : curves)
            if (!each.places.empty()) farthest = std::max(farthest, each.places.back()[0]);
        const double step = farthest > 10 ? std::ceil(farthest / 10) : 0.5;
        return {{"distance / mean spacing of the points of both", 0, farthest, step},
                {y, 0, high, 0.5},
                1,
                std::move(curves)};
    }

    const ClassSetPoints& set_;
    const ClassSetMeasures& measures_;
    const std::vector<std::size_t>& counts_;
    double area_;
};

/// Returns columns first, second, distance and g for all points, each class and each pair of classes.
std::string pairs_csv(const ClassSetPoints& set, const ClassSetMeasures& measures)
{
    std::string text = "first,second,distance,g\n";
    const auto add = [&](const std::string& a, const std::string& b, const ClassPairMeasures& pair) {
        for (std::size_t k = 0; k < pair.values.size(); ++k)
            text += fmt::format("{},{},{},{}\n", csv_quoted(a), csv_quoted(b),
                                pair.steps.step * static_cast<double>(k + 1) * set.unit, pair.values[k]);
    };
    add("", "", measures.all);
    for (const auto* const pairs : {&measures.own, &measures.cross})
        for (const ClassPairMeasures& pair : *pairs) add(set.names[pair.first], set.names[pair.second], pair);
    return text;
}

std::string marks_csv(const ClassSetPoints& set, const ClassSetMeasures& measures)
{
    const MarkCorrelation& marks = measures.marks;
    std::string text = marks.low.empty() ? "distance,mark_correlation\n" : "distance,mark_correlation,low,high\n";
    for (std::size_t k = 0; k < marks.values.size(); ++k) {
        text += fmt::format("{},{}", measures.all.steps.step * static_cast<double>(k + 1) * set.unit, marks.values[k]);
        text += marks.low.empty() ? "\n" : fmt::format(",{},{}\n", marks.low[k], marks.high[k]);
    }
    return text;
}

MarkPicture picture_of_classes(const ClassSetPoints& set, const ClassSetMeasures& measures)
{
    RegionLand land;
    std::array<double, 2> scale{1, 1};
    if (set.region) {
        land.whole = set.region->polygons();
    } else {
        scale = {set.box.sides[0], set.box.sides[1]};
        land.whole.polygons = {{{{0, 0}, {scale[0], 0}, scale, {0, scale[1]}}}};
    }
    std::vector<LandDots> dots;
    const double unit = set.region ? set.region->unit_length() : 1;
    for (std::size_t i = 0; i < set.names.size(); ++i) {
        PointSet some = set.of_class(i);
        const double spacing = std::sqrt(1 / static_cast<double>(some.size())) * unit;
        for (std::size_t k = 0; k < some.coordinates.size(); ++k) some.coordinates[k] *= scale[k % 2];
        const double mean = std::isfinite(measures.own[i].mean_first) ? measures.own[i].mean_first / set.unit : spacing;
        dots.push_back({class_color(i), std::move(some), std::clamp(0.16 * mean, 5e-4, 0.02)});
    }
    std::ranges::stable_sort(dots, std::greater{}, &LandDots::radius);
    return land_picture(land, box_of(land.whole), dots);
}

void add_spectra(const ClassSetPoints& set, const CrossSpectra& found, DistributionFiles& files,
                 DistributionResult& result)
{
    ClassSpectra spectra{.sets = 1, .classes = {}, .mean = found, .error = {}};
    for (std::size_t i = 0; i < set.names.size(); ++i) spectra.classes.push_back(static_cast<std::uint32_t>(i));
    add_class_spectra(set.points.size(), spectra, set.names, files, result);
}

DistributionResult measure_classes(const ClassSetSettings& settings, std::uint64_t /*seed*/,
                                   const DistributionPlace& place, DistributionFiles& files)
{
    const auto read = read_class_set(settings);
    const ClassSetPoints& set = *read;
    const ClassSetMeasures measures = measure_class_set(set, settings, place.on_step);
    std::vector<std::size_t> counts(set.names.size());
    for (const std::uint8_t each : set.classes) ++counts[each];
    DistributionResult result;
    result.facts = {fmt::format("{} classes", counts.size()), fmt::format("{} points", set.points.size()),
                    set.region ? "in " + set.region->name() : "on a torus"};
    for (const std::string& note : set.notes) result.facts.push_back(note);
    if (measures.labellings < settings.labellings)
        result.facts.emplace_back("Random labellings are left out: comparing so many pairs would take too long");
    if (!measures.spectra) result.facts.emplace_back("Cross spectra are left out: the sides of the box differ");
    files.add_marks("points.json", picture_of_classes(set, measures), "The points, a colour for each class.", result);
    const ClassSetCharts charts(set, measures, counts);
    files.add_curves(
        "cross-pairs", charts.cross(),
        "Cross pair correlation functions: they are 1 on average where two classes are independent, below 1 where "
        "they avoid each other, and above 1 where they attract each other.",
        result);
    files.add_curves("pairs", charts.own(), "Pair correlation functions of each class, and of all points.", result);
    files.add_curves(
        "marks", charts.marks(),
        "Mark correlation function: the probability that two points at a distance are of one class, over that of any "
        "two points. It is 1 on average if classes are given to points at random.",
        result);
    if (measures.spectra) add_spectra(set, *measures.spectra, files, result);
    write_whole_file(files.add("pairs.csv", result), pairs_csv(set, measures));
    write_whole_file(files.add("marks.csv", result), marks_csv(set, measures));
    result.numbers = class_set_numbers(set, measures, counts);
    result.tables = {table_of_classes(set, measures, counts), table_of_pairs(set, measures, counts)};
    return result;
}

}

Kind class_set_kind()
{
    return make_kind<ClassSetSettings>({"distribution", "class-set", "", "Points with classes",
                                        "Measure points with classes, made here or elsewhere", false},
                                       class_set_keys, class_set_label, measure_classes);
}

}
