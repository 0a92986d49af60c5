#include "reports/layout/distribution_pictures.hpp"

#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "base/images/srgb_light.hpp"
#include "base/text/noun.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/drawings/mark_image.hpp"
#include "reports/layout/series_panels.hpp"
#include "reports/plots/distribution_curves.hpp"
#include "reports/words/number_format.hpp"
#include "results/curve_tables.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace poissonlab {
namespace {

/// Bytes of light from 0 to 255.
void write_light_copy(const std::filesystem::path& picture, const std::filesystem::path& copy)
{
    PngPixels pixels = read_png(picture);
    for (std::uint8_t& value : pixels.values)
        value = static_cast<std::uint8_t>(std::lround(light_of_bytes()[value] * (255.0F / 65'535)));
    write_png(copy, pixels);
}

/// Curves that are stored as a picture; the caption's first sentence is the title.
Panel stored_curves(const std::filesystem::path& file, const std::string& caption)
{
    const std::string name = file.filename().string();
    const std::size_t end = std::min(caption.find_first_of(".:"), caption.size());
    std::string rest = caption.substr(std::min(caption.find_first_not_of(".: ", end), caption.size()));
    if (!rest.empty() && rest[0] >= 'a' && rest[0] <= 'z') rest[0] = static_cast<char>(rest[0] - 'a' + 'A');
    return {.stem = name.substr(0, name.size() - std::string(curves_ending).size()),
            .picture = chart_plot(read_curve_chart(file)),
            .title = caption.substr(0, end),
            .caption = std::move(rest)};
}

}

void lay_out_curves(ReportDistribution& distribution)
{
    const DistributionResult& stored = *distribution.stored;
    for (const DistributionPicture& picture : stored.pictures)
        if (picture.has_curves())
            distribution.curves.push_back(stored_curves(distribution.run->folder / picture.file, picture.caption));
    const auto file = std::ranges::find_if(stored.files, [](const std::string& name) {
        return name.ends_with(std::string("/") + file_names::region_curves);
    });
    if (file == stored.files.end()) return;
    const auto number = [&](const char* key) {
        const auto found = std::ranges::find(stored.numbers, key, &DistributionNumber::key);
        return found == stored.numbers.end() ? 0 : found->value;
    };
    const RegionSets sets{number("points") / number("area"),
                          static_cast<std::size_t>(number("envelope")),
                          false,
                          number("covariance_error"),
                          distribution.run->folder / *file,
                          false};
    std::ranges::move(region_curve_panels(read_region_curves(sets.file), sets, 0),
                      std::back_inserter(distribution.curves));
}

std::filesystem::path png_of(const ReportDistribution& distribution, const DistributionPicture& picture)
{
    const std::filesystem::path stored = distribution.run->folder / picture.file;
    if (!picture.has_marks()) return stored;
    return distribution.pictures / stored.filename().replace_extension(".png");
}

bool shows_tones(const ReportDistribution& distribution)
{
    return distribution.stored->kind == "stippling" || distribution.stored->kind == "hatching";
}

std::filesystem::path light_copy_of(const ReportDistribution& distribution, const DistributionPicture& picture)
{
    const std::filesystem::path stem = std::filesystem::path(picture.file).stem();
    return distribution.pictures / (stem.string() + "-light.png");
}

void draw_distribution_pictures(const ReportDistribution& distribution, PictureStore& store)
{
    for (const DistributionPicture& picture : distribution.stored->pictures) {
        if (!picture.has_marks()) continue;
        const std::filesystem::path file = distribution.run->folder / picture.file;
        const MarkPicture marks = read_mark_picture(file);
        const Drawing drawing = draw_marks(marks, file.parent_path());
        const std::filesystem::path png = png_of(distribution, picture);
        if (marks.ground.empty()) {
            write_drawing(png.parent_path() / png.stem(), drawing, drawing.width, store);
            continue;
        }
        const std::string input = read_whole_file(file) + read_whole_file(file.parent_path() / marks.ground);
        store.draw_once({png}, input, [&] { write_drawing_png(png, drawing, marks.pixels); });
    }
    if (!shows_tones(distribution)) return;
    for (const DistributionPicture& picture : distribution.stored->pictures) {
        if (picture.has_curves()) continue;
        const std::filesystem::path png = png_of(distribution, picture), copy = light_copy_of(distribution, picture);
        store.draw_once({copy}, "light " + read_whole_file(png), [&] { write_light_copy(png, copy); });
    }
}

namespace {

/// "The band reaches from the least to the largest of 39 sets ..."
std::string band_words(const RegionSets& sets)
{
    if (sets.envelope == 0) return {};
    return fmt::format(" The band reaches from the least to the largest of {} sets of as many random points in the "
                       "region{}; one random set leaves it at a distance in 2 of {} cases.",
                       format_count(sets.envelope), sets.has_density ? ", which follow the density" : "",
                       format_count(sets.envelope + 1));
}

std::string correction_words(const RegionSets& sets)
{
    const std::string begin = "Translation correction, by areas that the region and the moved region have in common, ";
    if (sets.covariance_error == 0) return begin + "in closed form.";
    return begin +
           fmt::format("from a table that is right to {} of the area.", format_significant(sets.covariance_error, 2));
}

Panel curve_panel(const RegionSets& sets, const char* stem, Plot plot, const char* title, std::string caption,
                  const std::string& guide)
{
    return {.stem = stem,
            .picture = std::move(plot),
            .title = title,
            .caption = std::move(caption),
            .guide = guide + band_words(sets),
            .stored = {{"csv", sets.file}}};
}

}

std::vector<Panel> region_curve_panels(const std::vector<RegionCurveRow>& rows, const RegionSets& sets,
                                       std::size_t index)
{
    const PlaneRegionCurves curves{index, &rows, sets.intensity, !sets.has_density, sets.is_in_metres};
    const std::string expected =
        sets.has_density ? "the number that random points that follow the density" : "the number that random points";
    const std::string of_formula = curves.has_formula ? " Dashes: random points." : "";
    std::vector<Panel> panels;
    panels.push_back(curve_panel(sets, "region-pair-correlation", region_pair_correlation_plot(curves),
                                 "Pair correlation in the region", correction_words(sets),
                                 "The number of points at each distance from a point, divided by " + expected +
                                     " would have there (dashed), smoothed by a kernel of 0.15 mean spacings to either "
                                     "side."));
    panels.push_back(curve_panel(
        sets, "region-l", region_l_plot(curves), "Ripley's L, less the distance",
        "Line: translation correction. Dashes: Ripley's isotropic one.",
        "<i>L</i> is the square root of <i>K</i>/π, and <i>K</i> is the mean number of further points within that "
        "distance "
        "of a point, divided by their density. Below 0 there are fewer points than " +
            expected +
            " would have: points keep apart. Above 0 they cluster. The curve is cumulative, so that a minimum distance "
            "still shows at larger distances."));
    panels.push_back(curve_panel(sets, "region-nearest", region_distance_plot(curves, RegionFunction::nearest),
                                 "Nearest neighbours, G", "Kaplan-Meier estimate." + of_formula,
                                 "The share of points whose nearest neighbour is within that distance. It is 0 up to "
                                 "the minimum distance; the steeper it rises there, the more even is the set."));
    panels.push_back(curve_panel(sets, "region-empty-space", region_distance_plot(curves, RegionFunction::empty_space),
                                 "Empty space, F", "Kaplan-Meier estimate." + of_formula,
                                 "The share of the region that has a point within that distance. It reaches 1 at the "
                                 "radius of the largest empty circle; the sooner it does, the smaller are the holes."));
    panels.push_back(
        curve_panel(sets, "region-j", region_j_plot(curves), "J",
                    "(1 − G) / (1 − F), up to where fewer than a thousandth of places are left.",
                    "Where J is above 1 (dashed), points keep apart at distances up to this; where it is below 1, they "
                    "cluster."));
    return panels;
}

Panel region_points_panel(const ReportSeries& series)
{
    const RegionResult& region = *series.stored->region;
    return {.stem = "points",
            .picture = MarkPanel{series.run->folder / region.picture_file},
            .title = "Points",
            .caption = fmt::format("{} {} in {}, of area {}{}{}.", format_count(series.stored->points_of_first()),
                                   noun(series.stored->points_of_first(), "point"), region.name,
                                   format_significant(region.area, 4), region.is_in_metres ? " m²" : "",
                                   first_of_several(series)),
            .guide =
                "A good set looks even but not regular. Clumps and holes waste samples; rows and repetition appear in "
                "sampled pictures as patterns that are not there.",
            .stored = {{"json", series.run->folder / region.picture_file}},
            .thumbnail = Thumbnail{"points", "Points"},
            .image_class = "framed"};
}

void add_region_panels(const ReportSeries& series, std::size_t index, std::vector<Panel>& panels)
{
    if (series.region_curves.empty()) return;
    const RegionResult& region = *series.stored->region;
    const RegionSets sets{static_cast<double>(series.stored->points) / region.area,
                          region.envelope,
                          region.has_density,
                          region.covariance_error,
                          series.run->folder / region.file,
                          region.is_in_metres};
    for (Panel& panel : region_curve_panels(series.region_curves, sets, index)) panels.push_back(std::move(panel));
}

}
