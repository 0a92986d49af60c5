#include "reports/layout/small_pictures.hpp"

#include <algorithm>

namespace poissonlab {

std::vector<SmallPicture> small_pictures(const ReportSeries& series)
{
    std::vector<SmallPicture> result;
    for (const char* kind : {"spectrum", "plate", "radial", "points"}) {
        const auto is_kind = [&](const Panel& panel) { return panel.thumbnail && panel.thumbnail->kind == kind; };
        const auto panel = std::ranges::find_if(series.panels, is_kind);
        if (panel == series.panels.end()) continue;
        const bool is_ink = panel->image_class.starts_with("ink");
        result.push_back({kind, panel->thumbnail->name, thumbnail_file(*panel), is_ink ? "ink framed" : "framed"});
    }
    return result;
}

}
