// poissonlab aperiodic sets: the aperiodic tile sets that the laboratory knows.
#include "app/commands/work_options.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

constexpr auto aperiodic_sets_notes =
    R"(Colours are the larger of the numbers of horizontal and vertical colours. The sets with a figure are those of the
dissertation's chapter 8. The set of 32 tiles exists as a printed picture only. The dissertation counts 24 colours of
Robinson's set, those of both kinds of edges together. Jeandel and Rao's set has four colours here: others
list it with five, 0 to 4, of which its authors merge 4 with 0.
  poissonlab aperiodic sets
  poissonlab aperiodic sets --json)";

void print_sets_json()
{
    auto sets = nlohmann::ordered_json::array();
    for (const AperiodicSet& set : aperiodic_sets()) {
        nlohmann::ordered_json json{{"title", set.title}, {"source", set.source}, {"available", set.tiles != nullptr}};
        if (!set.figure.empty()) json["figure"] = set.figure;
        if (set.tiles == nullptr) {
            json["note"] = set.note;
        } else {
            const WangList list = set.tiles();
            json["name"] = set.name;
            json["tiles"] = list.tiles.size();
            json["colors"] = color_count(list);
            json["horizontal_colors"] = list.colors.horizontal;
            json["vertical_colors"] = list.colors.vertical;
            for (const WangTile& t : list.tiles) json["wang_tiles"].push_back({t.north, t.east, t.south, t.west});
        }
        sets.push_back(std::move(json));
    }
    fmt::print("{}\n", sets.dump());
}

void print_sets(const bool& as_json)
{
    if (as_json) return print_sets_json();
    fmt::print("{:<14}{:>6}{:>9}{:>12}{:>10}  source\n", "name", "tiles", "colours", "horizontal", "vertical");
    for (const AperiodicSet& set : aperiodic_sets()) {
        if (set.tiles == nullptr) {
            fmt::print("not available: {}, {}\n", set.title, set.note);
            continue;
        }
        const WangList list = set.tiles();
        fmt::print("{:<14}{:>6}{:>9}{:>12}{:>10}  {}\n", set.name, list.tiles.size(), color_count(list),
                   list.colors.horizontal, list.colors.vertical, set.source);
    }
}

}

Command aperiodic_sets_command()
{
    const auto as_json = std::make_shared<bool>(false);
    return {"sets",
            "List the aperiodic sets of Wang tiles that are known",
            {json_option(*as_json, "Print JSON: their tiles as well, as [N, E, S, W]")},
            aperiodic_sets_notes,
            action_on(as_json, print_sets)};
}

}
