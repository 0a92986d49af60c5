// The panel of Voronoi cells: the picture, and what its colours mean.
#include "reports/drawings/cells_image.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

using Shares = std::array<double, cell_classes>;

// Of all cells of the first realization, as stored; or of those in the picture where nothing is stored.
Shares shares_of(const ReportSeries& series)
{
    if (const auto& stored = series.stored->measures.voronoi) return stored->neighbour_share;
    Shares shares{};
    for (const auto& cell : series.cells->cells)
        shares[cell_class(cell.neighbours)] += 1.0 / static_cast<double>(series.cells->cells.size());
    return shares;
}

PageData key(const Shares& shares)
{
    PageData entries{PageData::type::list};
    for (std::size_t i = 0; i < cell_classes; ++i) {
        PageData entry;
        entry.set("color", cell_class_color(i));
        entry.set("text", fmt::format("{}: {} %", cell_class_name(i), format_fixed(100 * shares[i], 1)));
        entries << entry;
    }
    PageData data;
    data.set("entries", entries);
    return data;
}

}

PageData cells_panel(const ReportSeries& series)
{
    if (!series.cells) return false;
    const auto& view = *series.cells;
    auto caption = fmt::format("Neighbours of {} cells", format_count(view.cells.size()));
    if (view.window < 1)
        caption += fmt::format(" in the window of {0} × {0} at the lower left", format_significant(view.window, 2));
    caption += series.stored->measures.voronoi ? "; shares are of all cells of the set" : "; shares are of these cells";
    if (series.stored->realizations > 1)
        caption += fmt::format(" (first of {} realizations)", series.stored->realizations);
    auto data = picture_panel(series, {"cells.svg", "cells.png", "is_cells", "framed"}, "Voronoi cells", caption + ".");
    data.set("cell_key", key(shares_of(series)));
    return data;
}

}
