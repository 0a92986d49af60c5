// The page's section on the construction of Poisson tile sets.
#include "base/text/noun.hpp"
#include "reports/drawings/construction_image.hpp"
#include "reports/drawings/square_regions.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {

namespace {

const std::array<const char*, stored_point_classes.size()> class_meanings{
    "points around the tile, which are held while others move", "points elsewhere on the torus",
    "points that are there already", "points of what is made here"};

const std::array<const char*, stored_point_classes.size()> set_class_meanings{
    "", "a dart that is refused", "points that are there already", "points that this step is about"};

}

/// "Black: points that are there already. Red: ...", what there is.
std::string construction_legend(const ReportConstruction& construction)
{
    const auto& meanings = is_set(construction) ? set_class_meanings : class_meanings;
    std::string text;
    for (std::size_t kind = construction.stored->scene.points.size(); kind-- > 0;) {
        if (construction.stored->scene.points[kind] == 0) continue;
        std::string color = point_color(kind).name;
        color[0] = static_cast<char>(color[0] - 'a' + 'A');
        text += fmt::format("{}{}: {}.", text.empty() ? "" : " ", color, meanings[kind]);
    }
    return text;
}

namespace {

bool shows_disks(const Scene& scene)
{
    return std::ranges::any_of(scene.panels, [](const ScenePanel& panel) {
        return panel.has_points() && !(panel.pieces.empty() && panel.tiles.empty());
    });
}

std::string caption_of(const ReportConstruction& construction)
{
    const Scene scene = pictured_scene(construction);
    std::string text;
    for (std::size_t i = 0; i < scene.panels.size(); ++i) {
        if (scene.panels[i].caption.empty()) continue;
        const std::string letter = scene.panels.size() > 1 ? panel_letter(i) : "";
        text += (text.empty() ? "" : " ") + letter + (letter.empty() ? "" : " ") + scene.panels[i].caption;
    }
    if (text.empty() && scene.panels.size() > 1) text = fmt::format("{} of them.", scene.panels.size());
    if (construction.stored->show == "points" || construction.stored->show == "tiling") return text;
    text += (text.empty() ? "" : " ") + construction_legend(construction);
    if (shows_disks(scene))
        text += scene.dimension == 2 ? " Circles have the Poisson disk radius."
                                     : " Spheres are drawn smaller than they are, and paler farther away.";
    return text;
}

}

PageData construction_facts(const ConstructionResult& stored)
{
    PageData facts{PageData::type::list};
    if (stored.kind == "set") {
        facts << PageData(stored.show);
        facts << PageData(
            fmt::format("{} {}", format_count(stored.points_per_tile), noun(stored.points_per_tile, "point")));
        return facts;
    }
    const bool is_template = stored.kind == "template";
    facts << PageData(stored.kind == "edge"     ? "edge-based Poisson disk tiles"
                      : stored.kind == "sphere" ? "corner-based Poisson sphere tiles"
                      : is_template             ? "template Poisson disk tiles"
                                                : "corner-based Poisson disk tiles");
    const std::string tiles = fmt::format("{} {}", format_count(stored.tiles), noun(stored.tiles, "tile"));
    facts << PageData(is_template ? tiles
                                  : fmt::format("{} {}, {}", stored.colors, noun(stored.colors, "colour"), tiles));
    facts << PageData(
        fmt::format("{} {} per tile", format_count(stored.points_per_tile), noun(stored.points_per_tile, "point")));
    facts << PageData(fmt::format("relative radius {}", format_exact(stored.relative_radius)));
    if (stored.show == "regions" || stored.show == "kinds") return facts;
    facts << PageData(fmt::format("{}, {} Lloyd {}{}", stored.filling, stored.lloyd_iterations,
                                  noun(static_cast<std::uint64_t>(stored.lloyd_iterations), "iteration"),
                                  stored.repulsion ? ", repulsion" : ""));
    return facts;
}

PageData construction_section(const ReportConstruction& construction, std::size_t index,
                              const std::filesystem::path& page_folder)
{
    const ConstructionResult& stored = *construction.stored;
    const std::string caption = caption_of(construction);
    PageData data;
    data.set("label", stored.label);
    data.set("anchor", fmt::format("construction-{}", index + 1));
    data.set("facts", construction_facts(stored));
    // Small pictures stay small.
    DrawingPoint size{};
    panel_places(pictured_scene(construction), size);
    data.set("width", fmt::format("{:.0f}", size[0]));
    data.set("steps", has_steps(construction) ? PageData(relative_link(page_folder, steps_page_of(construction)))
                                              : PageData(false));
    data.set("caption", caption);
    data.set("alt", fmt::format("{}. {}", stored.label, caption));
    data.set("source", relative_link(page_folder, construction.pictures / "construction.svg"));
    data.set("svg", relative_link(page_folder, construction.pictures / "construction.svg"));
    data.set("png", relative_link(page_folder, construction.pictures / "construction.png"));
    data.set("json", relative_link(page_folder, construction.run->folder / stored.file));
    return data;
}

}
