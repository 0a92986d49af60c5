#include "host/texture/joint/changed_runs.hpp"

namespace poissonlab {
namespace {

/// The pixel of a run that is so many to the east of its first one.
ChangedPixel pixel_of(const ChangedRun& run, int step)
{
    ChangedPixel pixel = run.first;
    pixel.pixel += static_cast<std::size_t>(step);
    pixel.source.x = static_cast<std::uint16_t>(pixel.source.x + step);
    pixel.tile_x += step;
    return pixel;
}

}

std::vector<ChangedRun> runs_of(const std::vector<ChangedPixel>& pixels)
{
    std::vector<ChangedRun> runs;
    for (const ChangedPixel& pixel : pixels)
        if (!runs.empty() && pixel == pixel_of(runs.back(), runs.back().length))
            ++runs.back().length;
        else
            runs.push_back({pixel, 1});
    runs.shrink_to_fit();
    return runs;
}

std::vector<ChangedPixel> pixels_of(const std::vector<ChangedRun>& runs)
{
    std::vector<ChangedPixel> pixels;
    for (const ChangedRun& run : runs)
        for (int step = 0; step < run.length; ++step) pixels.push_back(pixel_of(run, step));
    return pixels;
}

}
