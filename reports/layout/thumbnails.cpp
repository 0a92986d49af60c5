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
    write_thumbnail(run.root / run_thumbnail, drawing_of(read_png(run_picture(run))), run_thumbnail_size);
}

}
