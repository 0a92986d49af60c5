// kind = "stippling" and "hatching": a picture in dots or strokes, and how true its tones are.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.3, figures 7.3 and 7.4.
#include "host/distribution/density_measures.hpp"
#include "host/distribution/distribution_run.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/relaxed_places.hpp"
#include "host/distribution/stipple.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr int report_pixels = 1024;

/// How the marks found their places.
std::string placing_words(const StippleSettings& settings, const Stippling& stippling)
{
    if (settings.by == MarkPlaces::ranks)
        return "by ranks of " +
               (settings.method.tiles.empty() ? std::string("the self-similar tile") : method_words(settings.method));
    const std::string warped = "warped points of " + method_words(settings.method);
    if (settings.by == MarkPlaces::warping) return warped;
    if (stippling.asked < least_relaxed_places) return warped + ", too few to be relaxed";
    return fmt::format("{}, then {} iterations of Gaussian blue noise", warped, settings.iterations);
}

void add_tones(const TonesOfMarks& tones, const Stippling& stippling, bool has_strokes, DistributionResult& result)
{
    result.numbers.push_back({"mark_width", has_strokes ? "Width of a stroke" : "Diameter of a dot",
                              stippling.mark_width, "pixels of the picture"});
    result.numbers.push_back({"mark_area", has_strokes ? "Area of a stroke" : "Area of a dot", stippling.mark_area,
                              "square pixels: the ink of the picture over the number of marks"});
    result.numbers.push_back(
        {"tone_error", "Tone error", tones.error,
         "mean difference of the ink that a screen shows and the ink asked for over windows of 32 pixels; black is 1"});
    result.numbers.push_back({"darkest_ink", "Darkest sure tone", tones.darkest_ink,
                              "ink up to which marks of this size do not overlap where it is constant"});
    result.numbers.push_back(
        {"too_dark", "Too dark", tones.too_dark, "part of the pixels that have more ink than that"});
    result.numbers.push_back({"overlap", "Overlap", tones.overlap, "part of the laid ink that lies on other ink"});
}

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
    write_places(files.add("points.npy"), stippling.places,
                 static_cast<std::uint32_t>(std::max(picture.ink.width, picture.ink.height)), "");
    result.files.push_back("points.npy");
    add_tones(tones_of(picture, settings, stippling, coverage, place), stippling, settings.has_strokes, result);
    if (settings.by == MarkPlaces::ranks && settings.points > 0) {
        result.numbers.push_back({"asked_for", "Asked for", static_cast<double>(settings.points), "marks"});
        result.numbers.push_back({"points", "Marks", static_cast<double>(stippling.places.size()) / 2, "by ranks"});
    }
    result.numbers.push_back(
        {"density_error", "Density error", density_error(picture.density, stippling.places), density_error_meaning});
    return result;
}

}
