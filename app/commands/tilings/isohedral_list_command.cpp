// poissonlab isohedral list: the 93 types of isohedral tilings.
#include "app/commands/work_options.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>

namespace poissonlab {
namespace {

constexpr auto isohedral_list_notes =
    R"(The types of Gruenbaum and Shephard, found by enumeration. Symbol: the edges of a tile counterclockwise, equal letters
where a symmetry of the tiling maps one to another; after the semicolon what lies across each. Topology: that of the
Laves tiling. Aspects: tiles of a translational unit. Parameters: in how many ways corners can be moved. Curves: what
each may be, J any, S the same after half a turn, U the same in a mirror across it, I straight. Marked: tiles of any
shape are more symmetric than the type, so that only markings on them show it.
  poissonlab isohedral list)";

std::string curves_of(const IsohedralType& type)
{
    std::string curves;
    for (const EdgeShape shape : type.shape.curve_shapes) curves += name_of(shape);
    return curves;
}

void print_types_json()
{
    auto list = nlohmann::ordered_json::array();
    for (const IsohedralType& type : isohedral_types()) {
        const TileColoring coloring = proper_coloring(IsohedralTile(type, {}));
        list.push_back({{"ih", type.number},
                        {"symbol", type.symbol},
                        {"topology", type.topology},
                        {"aspects", type.shape.aspects.size()},
                        {"parameters", type.shape.parameters()},
                        {"marked", type.is_marked},
                        {"curves", curves_of(type)},
                        {"symmetries", type.shape.symmetries.size()},
                        {"colors", coloring.colors},
                        {"perfect", coloring.is_perfect}});
    }
    fmt::print("{}\n", list.dump(2));
}

void print_types(const bool& as_json)
{
    if (as_json) return print_types_json();
    fmt::print("{:<6}{:<12}{:<28}{:>8}{:>12}  {:<8}\n", "type", "topology", "symbol", "aspects", "parameters",
               "curves");
    for (const IsohedralType& type : isohedral_types())
        fmt::print("{:<6}{:<12}{:<28}{:>8}{:>12}  {:<8}{}\n", fmt::format("IH{}", type.number), type.topology,
                   type.symbol, type.shape.aspects.size(), type.shape.parameters(), curves_of(type),
                   type.is_marked ? "marked" : "");
}

}

Command isohedral_list_command()
{
    const auto as_json = std::make_shared<bool>(false);
    return {"list",
            "List the 93 types of isohedral tilings",
            {json_option(*as_json)},
            isohedral_list_notes,
            action_on(as_json, print_types)};
}

}
