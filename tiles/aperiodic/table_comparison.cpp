#include "tiles/aperiodic/table_comparison.hpp"

#include <algorithm>

namespace poissonlab {

WangList counted_tiles(const AperiodicSet& set)
{
    WangList list = set.tiles();
    if (set.name != "robinson") return list;
    for (WangTile& tile : list.tiles) {
        tile.east += list.colors.horizontal;
        tile.west += list.colors.horizontal;
    }
    list.colors.vertical += list.colors.horizontal;
    return list;
}

const std::vector<PrintedColumn>& printed_columns()
{
    using enum CornerConstruction;
    static const std::vector<PrintedColumn> columns{
        {"13/5", diagonal, "8.3", {{125, 13, 50}, {1240, 125, 418}, {14810, 1240, 4523}, {160168, 14810, 0}}},
        {"14/6", diagonal, "8.3", {{214, 14, 86}, {3052, 214, 1208}, {58910, 3052, 19274}, {1213029, 58910, 0}}},
        {"16/6", diagonal, "8.3", {{87, 16, 44}, {286, 87, 160}, {777, 286, 464}, {1642, 777, 0}}},
        {"24/24", diagonal, "8.3", {{203, 24, 72}, {540, 203, 326}, {2068, 540, 990}, {7092, 2068, 0}}},
        {"32/16", diagonal, "8.3", {{114, 32, 84}, {280, 114, 204}, {662, 280, 512}, {1124, 662, 0}}},
        {"13/5", horizontal, "8.4", {}},
        {"14/6", horizontal, "8.4", {}},
        {"16/6", horizontal, "8.4", {{44, 6, 24}, {138, 24, 82}, {438, 82, 271}, {1406, 271, 0}}},
        {"24/24", horizontal, "8.4", {{62, 12, 42}, {156, 42, 104}, {436, 104, 272}, {1154, 272, 0}}},
        {"32/16", horizontal, "8.4", {}},
        {"13/5", vertical, "8.7", {}},
        {"14/6", vertical, "8.7", {{86, 6, 36}, {504, 36, 216}, {2968, 216, 1272}, {17464, 1272, 0}}},
        {"16/6", vertical, "8.7", {{44, 6, 24}, {138, 24, 82}, {438, 82, 271}, {1406, 271, 0}}},
        {"24/24", vertical, "8.7", {{72, 12, 38}, {192, 38, 122}, {564, 122, 378}, {1584, 378, 0}}},
        {"32/16", vertical, "8.7", {}},
        {"13/5", rotation, "8.5", {{60, 9, 21}, {126, 42, 84}, {336, 149, 228}, {702, 456, 0}}, 13, 47},
        {"14/6", rotation, "8.5", {{94, 9, 23}, {210, 46, 136}, {596, 204, 372}, {1306, 744, 0}}, 14, 80},
        {"16/6", rotation, "8.5", {{49, 12, 32}, {113, 52, 80}, {257, 160, 226}, {545, 416, 0}}, 16, 33},
        {"24/24", rotation, "8.5", {{67, 24, 38}, {171, 76, 118}, {367, 224, 292}, {801, 584, 0}}, 24, 43},
        {"32/16", rotation, "8.5", {{90, 28, 52}, {212, 104, 164}, {464, 308, 386}, {972, 772, 0}}, 32, 58},
        {"13/5", subdivision, "8.6", {{52, 19, 36}, {208, 89, 176}, {832, 385, 768}, {3328, 1601, 0}}},
        {"14/6", subdivision, "8.6", {{56, 21, 40}, {224, 97, 192}, {896, 417, 832}, {3584, 1729, 0}}},
        {"16/6", subdivision, "8.6", {{64, 23, 44}, {256, 109, 216}, {1024, 473, 944}, {4096, 1969, 0}}},
        {"24/24", subdivision, "8.6", {{96, 49, 72}, {384, 169, 336}, {1536, 721, 1440}, {6144, 2977, 0}}},
        {"32/16", subdivision, "8.6", {{128, 49, 96}, {512, 225, 448}, {2048, 961, 1920}, {8192, 3969, 0}}}};
    return columns;
}

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
            for (const ConstructionStep& step :
                 repeat_construction(counted_tiles(*set), printed.construction, repetitions)) {
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
            CornerList corners = construct_corners(counted_tiles(set), construction).list;
            PeriodSearch search = search_periods(wang_list_of(corners), width);
            columns.push_back({set.title, construction, std::move(corners), std::move(search)});
        }
    }
    return columns;
}

}
