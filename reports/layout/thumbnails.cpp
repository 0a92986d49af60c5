#include "reports/layout/thumbnails.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

constexpr int run_thumbnail_size = 144;

/// The file of the run's picture: the first small picture of the series in the middle, which a grid's extremes are not.
/// Empty where a run has tables only.
fs::path run_picture(const ReportRun& run)
{
    if (!run.series.empty()) {
        const auto& series = run.series[run.series.size() / 2];
        return series.pictures / small_pictures(series).front().file;
    }
    if (!run.tilings.empty()) return run.tilings.front().pictures / "tiles.png";
    if (!run.constructions.empty()) return run.constructions.front().pictures / "construction.png";
    for (const auto* all : {&run.distributions, &run.schemes})
        for (const ReportDistribution& distribution : *all)
            for (const DistributionPicture& picture : std::views::reverse(distribution.stored->pictures))
                if (!picture.has_curves()) return png_of(distribution, picture);
    return {};
}

}

Drawing drawing_of(PngPixels pixels)
{
    const double width = pixels.width, height = pixels.height;
    return {width, height, {{Image{{}, width, std::move(pixels)}, {}, {}}}};
}

void write_thumbnail(const fs::path& path, Drawing drawing, int largest)
{
    const double block = std::ceil(std::max(drawing.width, drawing.height) / largest);
    const double wide = std::max(1.0, std::floor(drawing.width / block));
    drawing.height = block * std::max(1.0, std::floor(drawing.height / block));
    drawing.width = block * wide;
    write_drawing_png(path, drawing, static_cast<int>(wide));
}

void draw_run_thumbnail(const ReportRun& run)
{
    const fs::path picture = run_picture(run);
    const PngPixels pixels = picture.empty() ? PngPixels{1, 1, 1, {255}} : read_png(picture);
    write_thumbnail(run.root / run_thumbnail, drawing_of(pixels), run_thumbnail_size);
}

std::vector<SmallPicture> small_pictures(const ReportSeries& series)
{
    std::vector<SmallPicture> result;
    for (const char* kind : {"spectrum", "plate", "radial", "points"}) {
        const auto is_kind = [&](const Panel& panel) { return panel.thumbnail && panel.thumbnail->kind == kind; };
        const auto panel = std::ranges::find_if(series.panels, is_kind);
        if (panel == series.panels.end()) continue;
        const bool is_ink = panel->image_class.starts_with("ink");
        result.push_back({kind, panel->thumbnail->name, thumbnail_file(*panel), is_ink ? "ink framed" : "framed"});
    }
    return result;
}

}
