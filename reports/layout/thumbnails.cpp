#include "reports/layout/thumbnails.hpp"

#include "base/images/png_file.hpp"
#include "reports/layout/small_pictures.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

constexpr int run_thumbnail_size = 144;

std::uint8_t block_mean(const PngPixels& image, int column, int row, int channel, int block)
{
    int sum = 0;
    for (int y = row * block; y < (row + 1) * block; ++y)
        for (int x = column * block; x < (column + 1) * block; ++x) sum += image.values[image.at(x, y, channel)];
    return static_cast<std::uint8_t>(std::lround(static_cast<double>(sum) / (block * block)));
}

PngPixels smaller(const PngPixels& image, int largest)
{
    const int block = (std::max(image.width, image.height) + largest - 1) / largest;
    PngPixels result{std::max(1, image.width / block), std::max(1, image.height / block), image.channels, {}};
    result.values.resize(result.at(0, result.height, 0));
    for (int row = 0; row < result.height; ++row)
        for (int column = 0; column < result.width; ++column)
            for (int channel = 0; channel < image.channels; ++channel)
                result.values[result.at(column, row, channel)] = block_mean(image, column, row, channel, block);
    return result;
}

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

GreyImage smaller_image(const GreyImage& image, int largest)
{
    const auto small = smaller({image.width, image.height, 1, image.pixels}, largest);
    GreyImage result(small.width, small.height, 0);
    result.pixels = small.values;
    return result;
}

void draw_run_thumbnail(const ReportRun& run)
{
    const PngPixels image = smaller(read_png(run_picture(run)), run_thumbnail_size);
    write_png(run.root / run_thumbnail, PngLayout{image.width, image.height, image.channels},
              [&](int, int) { return image.values.data(); });
}

}
