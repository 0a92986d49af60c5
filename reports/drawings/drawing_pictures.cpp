#include "reports/drawings/drawing_pictures.hpp"

#include "base/files/whole_file.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

std::string write_drawing(const std::filesystem::path& stem, const Drawing& drawing, double pixels_wide,
                          PictureStore& store)
{
    const std::filesystem::path png = stem.string() + ".png";
    const auto svg = drawing_svg(drawing);
    const auto wide = static_cast<int>(std::ceil(std::min<double>(pixels_wide, max_drawing_pixels)));
    write_whole_file(stem.string() + ".svg", svg);
    store.draw_once({png}, svg + std::to_string(wide), [&] { write_drawing_png(png, drawing, wide); });
    return svg;
}

}
