// kind = "stippling" and "hatching": a picture in dots or strokes, and how true its tones are.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.3, figures 7.3 and 7.4.
#include "base/files/whole_file.hpp"
#include "host/distribution/density_measures.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/ink/plot.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/relaxed_places.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/distribution/stipple.hpp"
#include "host/kinds/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr int report_pixels = 1024;

/// Reads a length on paper.
void paper_length(Keys& keys, const char* key, double& length, const char* help, const char* otherwise)
{
    std::string text;
    keys.text(key, text, help).otherwise(otherwise);
    if (!keys.is_read() || !keys.is_given(key)) return;
    const auto read = millimetres_of(text);
    if (!read) throw keys.invalid(key, "must be a length such as 200mm, 20cm or 8in");
    length = *read;
}

void plotter_keys(Keys& keys, StippleSettings& s)
{
    PlotSheet sheet;
    paper_length(keys, "width", sheet.width, "for plotters: the width of the picture on paper, 200mm, 20cm or 8in",
                 "a pixel is a unit");
    paper_length(keys, "pen", sheet.pen, "for plotters: the width of the pen's line, 0.3mm",
                 "marks are drawn as wide as they are");
    if (!s.has_strokes) keys.word("dots", sheet.dots, dot_forms, "for plotters: dots are circles, or short strokes");
    keys.word("travel", sheet.travel, pen_travels, "for plotters: the order of marks");
    if (!keys.is_read()) return;
    if (sheet.pen > 0 && sheet.width == 0) throw keys.invalid("pen", "needs " + keys.name_of("width"));
    for (const char* key : {"travel", "dots", "pen", "width"})
        if (keys.is_given(key)) {
            sheet.option = key;
            s.plot = sheet;
        }
}

void mark_keys(Keys& keys, StippleSettings& s)
{
    const std::string width = s.has_strokes ? "stroke" : "dot";
    keys.picture_or_formula("image", s.image, s.from, "the picture, or a formula of its ink from 0 to 1").required();
    keys.word(
        "tones", s.tones, ink_tones,
        "ink is 1 - luminance, or 1 - lightness, which leaves more light where a picture is neither black nor white");
    keys.number("ink", s.ink, {0.001, 1}, "the part of the ink that is printed");
    keys.integer("points", s.points, 1, 1 << 24, "how many marks; their size follows (by ranks about so many)")
        .otherwise("what the width of marks needs");
    keys.number(width, s.mark_width, {0.01, 1e4}, s.has_strokes ? "the width of strokes" : "the diameter of dots")
        .unit("pixels of the picture")
        .otherwise("what the number of marks needs")
        .excludes("points");
    keys.word("by", s.by, mark_places, "how marks find their places");
    keys.integer("iterations", s.iterations, 1, 1'000'000, "of Gaussian blue noise: steps that all points take");
    keys.number("zoom", s.zoom, {1, 1000}, "the picture's middle is used, one over this of each side");
    keys.even_points(s.method);
    if (s.has_strokes) {
        keys.number("angle", s.angle, {-7, 7}, "the direction of strokes").unit("radians").otherwise("along lines");
        keys.number("slenderness", s.slenderness, {1, 100}, "how many times as long as wide strokes are");
    }
    plotter_keys(keys, s);
    if (!keys.is_read()) return;
    if (s.points == 0 && s.mark_width == 0)
        throw keys.problem(fmt::format("needs {} or {}", keys.name_of("points"), keys.name_of(width)));
    if (keys.is_given("iterations") && s.by != MarkPlaces::gaussian)
        throw keys.invalid("iterations", "is for " + keys.shown("by", "gaussian"));
    if (s.method.sampler && s.by == MarkPlaces::ranks)
        throw keys.invalid("method", "cannot be combined with " + keys.shown("by", "ranks"));
    keys.check("image", [&] { values_of_text(s.image, s.from, 1, 1); });
}

std::string mark_label(const StippleSettings& s)
{
    return fmt::format("{} of {}", s.has_strokes ? "Hatching" : "Stippling", name_of_input(s.image));
}

/// Says how the marks found their places.
std::string placing_words(const StippleSettings& settings, const Stippling& stippling)
{
    if (settings.by == MarkPlaces::ranks)
        return "by ranks of " + (settings.method.tiles.empty() ? std::string("the self-similar tile, ") + lattice_words
                                                               : method_words(settings.method));
    const std::string warped = "warped points of " + method_words(settings.method);
    if (settings.by == MarkPlaces::warping) return warped;
    if (stippling.asked < least_relaxed_places) return warped + ", too few to be relaxed";
    return fmt::format("{}, then {} iterations of Gaussian blue noise", warped, settings.iterations);
}

/// Adds the files for plotters, and how far the pen travels.
void add_plot(const StippleSettings& settings, const InkPicture& picture, const Stippling& stippling,
              DistributionFiles& files, DistributionResult& result)
{
    const Plot plot = plot_of(stippling.marks, picture.ink.width, picture.ink.height, stippling.margin, *settings.plot);
    result.facts.push_back(plot_words(plot));
    write_whole_file(files.add("plot.svg", result), plot_svg(plot));
    write_whole_file(files.add("plot.dxf", result), plot_dxf(plot, mark_label(settings)));
}

DistributionResult make_stippled(const StippleSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                 DistributionFiles& files)
{
    const InkPicture picture = read_ink(settings);
    const Stippling stippling = stipple(picture, settings, seed, place);
    const Coverage coverage = coverage_of(stippling.marks, picture.ink.width, picture.ink.height, 1);

    DistributionResult result;
    result.facts = {fmt::format("{} x {} pixels", picture.ink.width, picture.ink.height),
                    fmt::format("{} {}", stippling.places.size() / 2, settings.has_strokes ? "strokes" : "dots"),
                    placing_words(settings, stippling)};
    if (settings.tones == InkTones::lightness) result.facts.emplace_back("ink is 1 - lightness");
    if (settings.ink < 1) result.facts.push_back(fmt::format("{:.0f} % of the ink", 100 * settings.ink));
    if (!picture.ink.note.empty()) result.facts.push_back(picture.ink.note);
    MarkPicture marks = mark_picture(picture, stippling);
    marks.pixels = std::max(1, std::min(report_pixels, marks.pixels));
    files.add_marks("marks.json", marks, settings.has_strokes ? "The strokes." : "The dots.", result);
    write_coverage(files.add("coverage.png"), coverage);
    result.pictures.push_back(
        {"coverage.png", "Each pixel is as dark on a screen (sRGB) as the part of it that is covered."});
    write_coverage(files.add("ink.png"), {picture.ink.width, picture.ink.height, picture.ink.values, 0, 0});
    result.pictures.push_back(
        {"ink.png", "The ink that is asked for, as dark on a screen as the coverage is where both are alike."});
    write_places(files.add("points.npy", result), stippling.places,
                 static_cast<std::uint32_t>(std::max(picture.ink.width, picture.ink.height)), "");
    result.numbers =
        mark_numbers(picture, settings, stippling, tones_of(picture, settings, stippling, coverage, place));
    if (settings.plot) add_plot(settings, picture, stippling, files, result);
    return result;
}

}

DistributionNumbers mark_numbers(const InkPicture& picture, const StippleSettings& settings, const Stippling& stippling,
                                 const TonesOfMarks& tones)
{
    DistributionNumbers numbers;
    numbers.push_back({"mark_width", settings.has_strokes ? "Width of a stroke" : "Diameter of a dot",
                       stippling.mark_width, "pixels of the picture"});
    numbers.push_back({"mark_area", settings.has_strokes ? "Area of a stroke" : "Area of a dot", stippling.mark_area,
                       "square pixels: the ink of the picture over the number of marks"});
    numbers.push_back(
        {"tone_error", "Tone error", tones.error,
         "mean difference of the ink that a screen shows and the ink asked for over windows of 32 pixels; black is 1"});
    numbers.push_back({"darkest_ink", "Darkest sure tone", tones.darkest_ink,
                       "ink up to which marks of this size do not overlap where it is constant"});
    numbers.push_back({"too_dark", "Too dark", tones.too_dark, "part of the pixels that have more ink than that"});
    numbers.push_back({"overlap", "Overlap", tones.overlap, "part of the laid ink that lies on other ink"});
    if (settings.by == MarkPlaces::ranks && settings.points > 0) {
        numbers.push_back({"asked_for", "Asked for", static_cast<double>(settings.points), "marks"});
        numbers.push_back({"points", "Marks", static_cast<double>(stippling.places.size()) / 2, "by ranks"});
    }
    numbers.push_back(
        {"density_error", "Density error", density_error(picture.density, stippling.places), density_error_meaning});
    return numbers;
}

Kind stippling_kind()
{
    return make_kind<StippleSettings>(
        {"distribution", "stippling", "distribute stipple", "Stippling", "Print a picture in dots of one size"},
        mark_keys, mark_label, make_stippled);
}

Kind hatching_kind()
{
    StippleSettings strokes;
    strokes.has_strokes = true;
    return make_kind(
        {"distribution", "hatching", "distribute hatch", "Hatching", "Print a picture in strokes of one size"},
        mark_keys, mark_label, make_stippled, strokes);
}

}
