#include "reports/layout/distribution_pictures.hpp"

#include "base/files/whole_file.hpp"
#include "reports/drawings/drawing_pictures.hpp"
#include "reports/drawings/mark_image.hpp"
#include "reports/layout/plane_region_panels.hpp"
#include "results/curve_tables.hpp"
#include "results/file_names.hpp"

#include <algorithm>

namespace poissonlab {

bool is_of_textures(const ReportDistribution& distribution) { return distribution.stored->is_texture(); }
bool is_of_packings(const ReportDistribution& distribution) { return distribution.stored->kind == "packing"; }
bool is_of_densities(const ReportDistribution& distribution)
{
    return !is_of_textures(distribution) && !is_of_packings(distribution);
}

void lay_out_curves(ReportDistribution& distribution)
{
    const DistributionResult& stored = *distribution.stored;
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
    distribution.curves = region_curve_panels(read_region_curves(sets.file), sets, 0);
}

std::filesystem::path png_of(const ReportDistribution& distribution, const DistributionPicture& picture)
{
    const std::filesystem::path stored = distribution.run->folder / picture.file;
    if (!picture.has_marks()) return stored;
    return distribution.pictures / stored.filename().replace_extension(".png");
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
}

}
