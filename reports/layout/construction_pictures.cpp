#include "reports/layout/construction_pictures.hpp"

#include "reports/drawings/construction_image.hpp"
#include "reports/drawings/drawing_pictures.hpp"

namespace poissonlab {
namespace {

constexpr double pixels_a_unit = 2;

}

void draw_construction_picture(const ReportConstruction& construction, PictureStore& store)
{
    const Drawing drawing = draw_construction(construction.scene);
    write_drawing(construction.pictures / "construction", drawing, pixels_a_unit * drawing.width, store);
}

}
