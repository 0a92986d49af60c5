#include "reports/drawings/construction_image.hpp"

#include "reports/drawings/plane_panel.hpp"
#include "reports/drawings/space_panel.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

constexpr double picture_width = 860;
constexpr double widest_panel = 400; // and highest
constexpr double margin = 14;
constexpr double gap = 26;         // more than two disks at the borders of panels
constexpr double label_space = 22; // from a row of panels to the middle of its letters, and on to the next row
constexpr double letter_size = 16;

DrawingPoint panel_size(const Scene& scene, const ScenePanel& panel)
{
    return scene.dimension == 2 ? plane_panel_size(panel) : space_panel_size(panel);
}

bool has_labels(const Scene& scene)
{
    return scene.panels.size() > 1 &&
           std::ranges::any_of(scene.panels, [](const ScenePanel& panel) { return !panel.caption.empty(); });
}

}

std::string panel_letter(std::size_t panel)
{
    return panel < 26 ? std::string{'(', static_cast<char>('a' + panel), ')'} : "";
}

std::vector<PanelPlace> panel_places(const Scene& scene, DrawingPoint& size)
{
    const std::size_t columns = std::min(scene.columns, scene.panels.size());
    double widest = 0, highest = 0;
    for (const ScenePanel& panel : scene.panels) {
        widest = std::max(widest, panel_size(scene, panel)[0]);
        highest = std::max(highest, panel_size(scene, panel)[1]);
    }
    const auto count = static_cast<double>(columns);
    const double room = (picture_width - 2 * margin - (count - 1) * gap) / count;
    const double scale =
        columns == 1 ? room / widest : std::min({room, widest_panel, widest_panel * widest / highest}) / widest;
    const double pitch = scale * widest;
    std::vector<PanelPlace> places;
    double y = margin;
    for (std::size_t first = 0; first < scene.panels.size(); first += columns) {
        const std::size_t end = std::min(first + columns, scene.panels.size());
        double high = 0;
        for (std::size_t i = first; i < end; ++i) high = std::max(high, scale * panel_size(scene, scene.panels[i])[1]);
        for (std::size_t i = first; i < end; ++i) {
            const DrawingPoint own = panel_size(scene, scene.panels[i]);
            const double x = margin + static_cast<double>(i - first) * (pitch + gap);
            places.push_back({{x + (pitch - scale * own[0]) / 2, y + (high - scale * own[1]) / 2},
                              scale,
                              {x + pitch / 2, y + high + label_space}});
        }
        y += high + (has_labels(scene) ? 2 * label_space : gap);
    }
    size = {2 * margin + count * (pitch + gap) - gap, y - (has_labels(scene) ? label_space : gap) + margin};
    return places;
}

Drawing draw_construction(const Scene& scene)
{
    DrawingPoint size{};
    const std::vector<PanelPlace> places = panel_places(scene, size);
    Drawing drawing{size[0], size[1], {}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ScenePanel& panel = scene.panels[i];
        const auto [origin, scale, label] = places[i];
        if (scene.dimension == 2)
            add_plane_panel(drawing.shapes, scene, panel, origin, scale);
        else
            add_space_panel(drawing.shapes, scene, panel, origin, scale);
        // Half of a small letter's height below the middle.
        if (has_labels(scene))
            drawing.shapes.push_back(
                {Text{{label[0], label[1] + 0.27 * letter_size}, letter_size, panel_letter(i), true}, "#202020", {}});
    }
    return drawing;
}

}
