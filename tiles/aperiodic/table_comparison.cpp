#include "tiles/aperiodic/table_comparison.hpp"

#include "tiles/aperiodic/aperiodic_sets.hpp"

#include <algorithm>

namespace poissonlab {

bool ComparedColumn::agrees() const
{
    if (!here) return false;
    if (printed.steps.empty()) return here->size() == 1 && patterns > here->front().tiles;
    return *here == printed.steps && white == printed.white && black == printed.black;
}

std::vector<ComparedColumn> compare_tables(const std::function<void(const PrintedColumn&)>& on_step)
{
    std::vector<ComparedColumn> columns;
    for (const PrintedColumn& printed : printed_columns()) {
        if (on_step) on_step(printed);
        ComparedColumn column{printed, std::nullopt};
        const auto set = std::ranges::find_if(aperiodic_sets(), [&](const AperiodicSet& candidate) {
            return candidate.tiles != nullptr && candidate.title.ends_with(" " + printed.set);
        });
        if (set != aperiodic_sets().end()) {
            column.here.emplace();
            const std::size_t repetitions = std::max<std::size_t>(1, printed.steps.size());
            for (const ConstructionStep& step : repeat_construction(set->tiles(), printed.construction, repetitions)) {
                const bool is_last = column.here->size() + 1 == printed.steps.size(); // without Wang colours
                column.here->push_back(
                    {step.corners.list.tiles.size(), step.corners.list.colors, is_last ? 0 : color_count(step.wang)});
                if (column.here->size() > 1) continue;
                column.patterns = step.corners.patterns;
                column.white = step.corners.white;
                column.black = step.corners.black;
            }
        }
        columns.push_back(std::move(column));
    }
    return columns;
}

std::vector<SearchedColumn> search_constructions(std::size_t width)
{
    std::vector<SearchedColumn> columns;
    for (const AperiodicSet& set : aperiodic_sets()) {
        if (set.tiles == nullptr) continue;
        for (std::size_t i = 0; i < corner_constructions.all().size(); ++i) {
            const auto construction = static_cast<CornerConstruction>(i);
            CornerList corners = construct_corners(set.tiles(), construction).list;
            PeriodSearch search = search_periods(wang_list_of(corners), width);
            columns.push_back({set.title, construction, std::move(corners), std::move(search)});
        }
    }
    return columns;
}

}
