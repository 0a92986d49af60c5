#include "tests/reports/support/drawn.hpp"

#include "base/files/whole_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>

namespace poissonlab::test {

ColorPicture drawn(const Drawing& drawing, int pixels_wide)
{
    const TemporaryFolder folder;
    write_drawing_png(folder.path() / "a.png", drawing, pixels_wide);
    return decode_color_png(read_whole_file(folder.path() / "a.png"));
}

// A whole number of units wide, so that the scale is exact.
Pixels::Pixels(const Drawing& drawing, int scale)
    : scale_(scale), picture_(drawn({std::ceil(drawing.width), drawing.height, drawing.shapes},
                                    static_cast<int>(std::ceil(drawing.width)) * scale))
{}

std::string Pixels::at(double x, double y) const
{
    return picture_.at(static_cast<int>(std::floor(x * scale_)), static_cast<int>(std::floor(y * scale_)));
}

double area_of(const std::vector<DrawingPoint>& outline)
{
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& [x0, y0] = outline[i];
        const auto& [x1, y1] = outline[(i + 1) % outline.size()];
        twice += x0 * y1 - x1 * y0;
    }
    return std::abs(twice) / 2;
}

std::map<std::string, double> filled_areas(const Drawing& drawing)
{
    std::map<std::string, double> areas;
    for (const Shape& shape : drawing.shapes)
        if (!shape.fill.empty() && !std::holds_alternative<Text>(shape.form))
            areas[shape.fill] += area_of(std::get<Polygon>(shape.form));
    return areas;
}

}
