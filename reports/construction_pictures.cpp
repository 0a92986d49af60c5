#include "reports/construction_pictures.hpp"

#include "io/whole_file.hpp"
#include "reports/construction_image.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double pixels_a_unit = 2;

}

void draw_construction_picture(const ReportConstruction& construction)
{
    const Drawing drawing = draw_construction(construction.scene);
    write_whole_file(construction.pictures / "construction.svg", drawing_svg(drawing));
    const double wide = std::min<double>(pixels_a_unit * drawing.width, max_drawing_pixels);
    write_drawing_png(construction.pictures / "construction.png", drawing, static_cast<int>(std::ceil(wide)));
}

}
