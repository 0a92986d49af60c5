// poissonlab aperiodic convert: corner tile sets made of Wang tile sets, once or again and again.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 8.3 and 8.4, tables 8.1 to 8.7.
#include "app/commands/tilings/aperiodic_choice.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tiles/aperiodic/tile_list.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numeric>

namespace poissonlab {
namespace {

constexpr auto aperiodic_convert_notes =
    R"(A file has a line for each tile: the colours of north, east, south and west, any words. After a first line "corner"
they are those of north-east, south-east, south-west and north-west corners. # begins a comment.
A repetition makes corner tiles of Wang tiles, and Wang tiles of those again: a line each, or an entry of the list that
--json prints. "ambiguous": several patterns of Wang tiles give the same corner tile, so that corner tiles do not tell
the Wang tiles; the dissertation says "failed". There is no repetition after it.
  poissonlab aperiodic convert kari --construction diagonal --repeat 3
  poissonlab aperiodic convert ammann --construction rotation --out tiles.svg)";

constexpr std::size_t most_drawn_tiles = 20'000;

void print_steps(const std::vector<ConstructionStep>& steps, CornerConstruction construction)
{
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const ConstructedCorners& corners = steps[i].corners;
        fmt::print("{}: {} corner tiles", i + 1, corners.list.tiles.size());
        if (construction == CornerConstruction::rotation)
            fmt::print(" ({} white, {} black)", corners.white, corners.black);
        fmt::print(" over {} colours; {} Wang tiles over {} colours\n", corners.list.colors, steps[i].wang.tiles.size(),
                   color_count(steps[i].wang));
        if (corners.is_ambiguous())
            fmt::print("   ambiguous: {} patterns of Wang tiles give {} corner tiles\n", corners.patterns,
                       corners.list.tiles.size());
    }
}

void print_steps_json(const std::vector<ConstructionStep>& steps, CornerConstruction construction)
{
    auto list = nlohmann::ordered_json::array();
    for (const ConstructionStep& step : steps) {
        nlohmann::ordered_json json{
            {"tiles", step.corners.list.tiles.size()}, {"colors", step.corners.list.colors},
            {"wang_tiles", step.wang.tiles.size()},    {"wang_colors", color_count(step.wang)},
            {"patterns", step.corners.patterns},       {"ambiguous", step.corners.is_ambiguous()}};
        if (construction == CornerConstruction::rotation) {
            json["white"] = step.corners.white;
            json["black"] = step.corners.black;
        }
        list.push_back(std::move(json));
    }
    fmt::print("{}\n", list.dump(2));
}

/// The corner tiles, as a picture or as the text of a file of tiles.
void write_corners(const std::filesystem::path& file, const std::string& name, const ConstructionStep& step)
{
    if (file.extension() != ".svg" && file.extension() != ".png") {
        write_whole_file(file, tile_list_text(step.corners.list));
        return;
    }
    const std::size_t count = step.corners.list.tiles.size();
    if (count > most_drawn_tiles)
        throw InputError(fmt::format("aperiodic convert: --out {}: {} tiles cannot be drawn (at most {})",
                                     file.string(), count, most_drawn_tiles));
    std::vector<ListPlace> places(count);
    std::iota(places.begin(), places.end(), ListPlace{0});
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    write_tile_picture(file, {name, step.wang, step.corners.list}, places, columns, true);
}

void convert(const AskedTiles& options)
{
    const CornerConstruction construction = chosen_construction("aperiodic convert", options.construction);
    std::filesystem::path out;
    if (!options.out.empty())
        out = checked_output("aperiodic convert", "--out", options.out, {{".svg", ".png", ".txt"}, false, true});
    const ChosenTiles chosen = chosen_set("aperiodic convert", options.set);
    const auto steps = repeat_construction(chosen.wang, construction, options.repeat);
    if (!out.empty()) write_corners(out, chosen.name, steps.back());
    if (options.as_json)
        print_steps_json(steps, construction);
    else
        print_steps(steps, construction);
}

}

Command aperiodic_convert_command()
{
    const auto o = std::make_shared<AskedTiles>();
    return {
        "convert",
        "Make a corner tile set of a Wang tile set, and Wang tiles of that",
        {{"SET", &o->set, aperiodic_set_help},
         {"--construction", &o->construction, "diagonal, horizontal, vertical, rotation or subdivision", "NAME",
          required},
         allowing({"--repeat", &o->repeat, "How often, each time on the Wang tiles of the last one; default: 1", "K"},
                  Integers{1, most_repetitions}),
         {"--out", &o->out, "Where the last corner tiles go: a picture (.svg, .png), else a file of tiles (.txt)",
          "FILE"},
         json_option(o->as_json)},
        aperiodic_convert_notes,
        action_on(o, convert)};
}

}
