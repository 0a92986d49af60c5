#include "reports/drawings/mark_image.hpp"

#include <utility>

namespace poissonlab {

Drawing draw_marks(const MarkPicture& picture, const std::filesystem::path& folder)
{
    const double scale = picture.pixels / picture.width;
    Drawing drawing{
        .width = scale * picture.width, .height = scale * picture.height, .shapes = {}, .keeps_tones = true};
    const auto place = [&](double x, double y) { return DrawingPoint{scale * x, scale * (picture.height - y)}; };
    if (!picture.ground.empty())
        drawing.shapes.push_back({Image{{0, 0}, drawing.width, read_png(folder / picture.ground)}, {}, {}});
    for (const MarkGroup& group : picture.groups) {
        for (const auto& corners : group.polygons) {
            Polygon polygon;
            for (const auto& [x, y] : corners) polygon.push_back(place(x, y));
            drawing.shapes.push_back({std::move(polygon), group.color, {}});
        }
        for (const auto& [x, y, radius] : group.disks)
            drawing.shapes.push_back({Disk{place(x, y), scale * radius}, group.color, {}});
        for (const auto& [x1, y1, x2, y2, width] : group.strokes)
            drawing.shapes.push_back({Line{{place(x1, y1), place(x2, y2)}}, {}, group.color, scale * width});
    }
    for (const MarkWords& words : picture.words)
        drawing.shapes.push_back(
            {Text{place(words.place[0], words.place[1]), scale * words.size, words.words, true}, "#000000", {}});
    return drawing;
}

}
