#include "app/commands/picture_output.hpp"

#include "base/files/whole_file.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double pixels_a_unit = 2;

}

void write_picture_file(const std::filesystem::path& file, const Drawing& drawing, int pixels)
{
    const int usual = std::min(max_drawing_pixels, static_cast<int>(std::ceil(pixels_a_unit * drawing.width)));
    if (file.extension() == ".svg")
        write_whole_file(file, drawing_svg(drawing));
    else
        write_drawing_png(file, drawing, pixels > 0 ? pixels : usual);
}

}
