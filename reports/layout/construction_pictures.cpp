#include "reports/layout/construction_pictures.hpp"

#include "reports/drawings/construction_image.hpp"
#include "reports/drawings/drawing_pictures.hpp"

namespace poissonlab {
namespace {

constexpr double pixels_a_unit = 2;

}

bool is_set(const ReportConstruction& construction) { return construction.stored->kind == "set"; }

bool has_steps(const ReportConstruction& construction)
{
    const Scene& scene = construction.scene;
    const bool is_list = scene.panels.front().caption.empty();
    return scene.dimension == 2 && scene.panels.size() > 1 && !is_list;
}

std::filesystem::path steps_page_of(const ReportConstruction& construction)
{
    return construction.pictures / "steps.html";
}

Scene pictured_scene(const ReportConstruction& construction)
{
    constexpr std::size_t few_panels = 6;
    const std::vector<ScenePanel>& all = construction.scene.panels;
    if (!is_set(construction) || all.size() <= few_panels) return construction.scene;
    Scene scene = construction.scene;
    scene.panels.clear();
    for (std::size_t i = 0; i < few_panels; ++i) scene.panels.push_back(all[i * (all.size() - 1) / (few_panels - 1)]);
    return scene;
}

void draw_construction_picture(const ReportConstruction& construction, PictureStore& store)
{
    const Drawing drawing = draw_construction(pictured_scene(construction));
    write_drawing(construction.pictures / "construction", drawing, pixels_a_unit * drawing.width, store);
}

}
