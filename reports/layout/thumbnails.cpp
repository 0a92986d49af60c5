#include "reports/layout/thumbnails.hpp"

#include "base/images/png_file.hpp"
#include "reports/layout/small_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

constexpr int run_thumbnail_size = 144;

// The file of the run's picture: the first small picture of the series in the middle, which a grid's extremes are not.
fs::path run_picture(const ReportRun& run)
{
    if (!run.series.empty()) {
        const auto& series = run.series[run.series.size() / 2];
        return series.pictures / small_pictures(series).front().file;
    }
    if (!run.tilings.empty()) return run.tilings.front().pictures / "tiles.png";
    return run.constructions.front().pictures / "construction.png";
}

}

int thumbnail_width(int width, int height, int largest)
{
    return std::max(1, width / ((std::max(width, height) + largest - 1) / largest));
}

void write_thumbnail(const fs::path& path, PngPixels pixels, int largest)
{
    const int wide = thumbnail_width(pixels.width, pixels.height, largest);
    const double width = pixels.width, height = pixels.height;
    write_drawing_png(path, {width, height, {{Image{{}, width, std::move(pixels)}, {}, {}}}}, wide);
}

Drawing draw_radial_thumbnail(const Curve& curve, const CurveScales& scales)
{
    constexpr double width = 160, height = 120, dash = 4, gap = 3;
    const auto y = [&](double power) { return height * (1 - std::min(power, scales.max_power) / scales.max_power); };
    Drawing drawing{width, height, {}};
    for (double x = 0; x < width; x += dash + gap)
        drawing.shapes.push_back({Line{{{x, y(1)}, {x + dash, y(1)}}}, {}, "#777777", 1});
    Line power;
    for (const auto& bin : curve.bins)
        if (std::isfinite(bin.power) && bin.frequency <= curve.max_frequency)
            power.points.push_back({width * bin.frequency / curve.max_frequency, y(bin.power)});
    drawing.shapes.push_back({std::move(power), {}, "#000000", 1});
    return drawing;
}

void draw_run_thumbnail(const ReportRun& run)
{
    write_thumbnail(run.root / run_thumbnail, read_png(run_picture(run)), run_thumbnail_size);
}

}
