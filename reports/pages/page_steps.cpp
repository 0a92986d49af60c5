// The page that shows a construction step by step: its panels, one at a time.
#include "reports/drawings/construction_image.hpp"
#include "reports/layout/tiling_pictures.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace poissonlab {

namespace {

/// All places of a scene, each once; steps name them by ranges of their numbers.
class ScenePlaces
{
public:
    /// "[first,end,first,end]"
    std::string ranges(const std::vector<TilePosition>& positions)
    {
        std::vector<std::size_t> bounds;
        for (const TilePosition& position : positions) {
            const std::size_t number = number_of(position);
            if (!bounds.empty() && bounds.back() == number)
                ++bounds.back();
            else
                bounds.insert(bounds.end(), {number, number + 1});
        }
        return fmt::format("[{}]", fmt::join(bounds, ","));
    }

    std::string text() const { return fmt::format("[{}]", fmt::join(coordinates_, ",")); }

private:
    std::size_t number_of(const TilePosition& position)
    {
        const auto [found, is_new] = numbers_.try_emplace(position, numbers_.size());
        if (is_new) coordinates_.insert(coordinates_.end(), position.begin(), position.begin() + 2);
        return found->second;
    }

    std::map<TilePosition, std::size_t> numbers_;
    std::vector<std::int32_t> coordinates_;
};

/// Sets have many steps, whose points the page's script draws.
std::string set_steps_json(const ReportConstruction& construction)
{
    ScenePlaces places;
    std::vector<std::string> steps;
    for (const ScenePanel& panel : construction.scene.panels) {
        std::vector<std::string> points;
        for (const auto& list : panel.points) points.push_back(places.ranges(list));
        steps.push_back(fmt::format("{{\"caption\":{},\"radius\":{:.6g},\"points\":[{}]}}", script_text(panel.caption),
                                    panel.radius, fmt::join(points, ",")));
    }
    return fmt::format("{{\"side\":{},\"moves\":{},\"places\":{},\n\"steps\":[\n{}]}}", tile_units,
                       construction.stored->show == "lloyd", places.text(), fmt::join(steps, ",\n"));
}

/// Steps of tiles are few, with regions: each is a picture.
std::string tile_steps_json(const ReportConstruction& construction)
{
    std::vector<std::string> steps;
    for (const ScenePanel& panel : construction.scene.panels) {
        Scene alone = construction.scene;
        alone.panels = {panel};
        steps.push_back(fmt::format("{{\"caption\":{},\"svg\":{}}}", script_text(panel.caption),
                                    script_text(drawing_svg(draw_construction(alone)))));
    }
    return fmt::format("{{\"steps\":[\n{}]}}", fmt::join(steps, ",\n"));
}

}

std::string render_steps_page(const Site& site, const ReportRun& run, const ReportConstruction& construction)
{
    const std::filesystem::path file = steps_page_of(construction);
    const std::filesystem::path folder = file.parent_path();
    const ConstructionResult& stored = *construction.stored;
    PageData page;
    page.set("title", stored.label);
    page.set("overview", relative_link(folder, site.out / overview_page));
    page.set("run_link", site.has_several_runs() ? PageData(relative_link(folder, page_of(run))) : PageData(false));
    page.set("run_title", run.stored->title);
    page.set("facts", construction_facts(stored));
    page.set("legend", construction_legend(construction));
    page.set("picture", relative_link(folder, construction.pictures / "construction.svg"));
    page.set("json_link", relative_link(folder, construction.run->folder / stored.file));
    page.set("last", std::to_string(construction.scene.panels.size() - 1));
    page.set("json", is_set(construction) ? set_steps_json(construction) : tile_steps_json(construction));
    return render_in_frame(site, {file, stored.label + " · " + site.title, {"steps.js"}}, "steps", page);
}

}
