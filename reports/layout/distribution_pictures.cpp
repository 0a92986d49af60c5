#include "reports/layout/distribution_pictures.hpp"

#include "base/files/whole_file.hpp"
#include "base/images/png_file.hpp"
#include "base/images/srgb_light.hpp"
#include "reports/drawings/drawing_pictures.hpp"
#include "reports/drawings/mark_image.hpp"
#include "reports/layout/plane_region_panels.hpp"
#include "reports/plots/chart_curves.hpp"
#include "results/curve_tables.hpp"
#include "results/file_names.hpp"

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

bool is_of_textures(const ReportDistribution& distribution) { return distribution.stored->is_texture(); }
bool is_of_packings(const ReportDistribution& distribution) { return distribution.stored->kind == "packing"; }
bool is_of_densities(const ReportDistribution& distribution)
{
    return !is_of_textures(distribution) && !is_of_packings(distribution);
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
    const RegionSets sets{number("points") / number("area"), static_cast<std::size_t>(number("envelope")), false,
                          number("covariance_error"), distribution.run->folder / *file};
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

}
