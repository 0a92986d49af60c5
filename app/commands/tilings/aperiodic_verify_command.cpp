// poissonlab aperiodic verify: the search for periods of a tile set, by the tallest cylinder of each circumference.
#include "app/commands/tilings/aperiodic_choice.hpp"
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "tiles/aperiodic/cylinder_search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace poissonlab {
namespace {

constexpr auto aperiodic_verify_notes =
    R"(For each circumference w up to W: rows that close after w tiles are stacked until nothing fits. What is printed is the
height of the tallest cylinder of rows, and of columns. Where cylinders have "any" height, the set has a tiling that
repeats along both axes: the tiles of the first that is found are printed, numbered from 0 in the order of the set, and
drawn with --out, four copies of them. The heights of an axis end there, those of the other axis go on. Corner tile sets
are searched as the Wang tiles that they are equivalent to.
No search proves that a set is aperiodic: there may be a longer period.
  poissonlab aperiodic verify kari --width 10
  poissonlab aperiodic verify ammann --construction horizontal --width 8 --out period.png)";

constexpr std::uint32_t largest_width = 64;

struct AperiodicVerifyOptions : AskedTiles
{
    std::uint32_t width = 0;
};

std::vector<std::span<const ListPlace>> rows_of(const PeriodicTiling& tiling)
{
    std::vector<std::span<const ListPlace>> rows;
    for (std::size_t y = 0; y < tiling.height; ++y)
        rows.push_back(std::span(tiling.tiles).subspan(y * tiling.width, tiling.width));
    return rows;
}

const char* axis_name(CylinderAxis axis) { return axis == CylinderAxis::horizontal ? "horizontal" : "vertical"; }

/// A line of the table: heights, and "any" where those of an axis end.
void print_heights(const PeriodSearch& search, std::size_t circumference)
{
    const auto height = [&](const std::vector<std::size_t>& heights) -> std::string {
        if (heights.size() >= circumference) return std::to_string(heights[circumference - 1]);
        return heights.size() + 1 == circumference ? "any" : "-";
    };
    fmt::print("{:>13}{:>10}{:>10}\n", circumference, height(search.horizontal_heights),
               height(search.vertical_heights));
    std::fflush(stdout);
}

void print_outcome(const PeriodSearch& search, std::uint32_t width)
{
    if (!search.period) {
        fmt::print("no period up to {} tiles along either axis; that there is none is not proven by this\n", width);
        return;
    }
    const PeriodicTiling& period = *search.period;
    fmt::print("periodic: these {} x {} tiles repeat", period.width, period.height);
    if (period.shear > 0)
        fmt::print(", copies {} moved {} tiles to the {}",
                   period.axis == CylinderAxis::horizontal ? "below" : "to the east", period.shear,
                   period.axis == CylinderAxis::horizontal ? "east" : "south");
    fmt::print("\n");
    for (const auto row : rows_of(*search.period)) fmt::print("{}\n", fmt::join(row, " "));
}

void print_outcome_json(const PeriodSearch& search, const std::string& name, std::uint32_t width)
{
    nlohmann::ordered_json json{
        {"set", name},
        {"width", width},
        {"periodic", search.period.has_value()},
        {"period", nullptr},
        {"heights", {{"horizontal", search.horizontal_heights}, {"vertical", search.vertical_heights}}}};
    if (search.period) {
        json["period"] = {{"axis", axis_name(search.period->axis)},
                          {"width", search.period->width},
                          {"height", search.period->height},
                          {"shear", search.period->shear}};
        for (const auto row : rows_of(*search.period))
            json["period"]["tiles"].push_back(std::vector<ListPlace>(row.begin(), row.end()));
    }
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

/// Two copies of the period along each axis: that they fit can be seen.
void draw_period(const std::filesystem::path& file, const ChosenTiles& chosen, const PeriodicTiling& tiling)
{
    std::vector<ListPlace> places;
    for (std::size_t y = 0; y < 2 * tiling.height; ++y)
        for (std::size_t x = 0; x < 2 * tiling.width; ++x) places.push_back(tiling.at(x, y));
    write_tile_picture(file, chosen, places, 2 * tiling.width, false);
}

/// Searches and prints heights. A circumference of one axis with too many rows is no error where the other axis has
/// shown a period.
PeriodSearch searched(const WangList& list, const AperiodicVerifyOptions& options)
{
    PeriodSearch known;
    std::size_t circumference = 0;
    try {
        return search_periods(list, options.width, [&](const PeriodSearch& so_far) {
            known = so_far;
            ++circumference;
            if (!options.as_json) print_heights(so_far, circumference);
        });
    } catch (const InputError& error) {
        if (!known.period) throw;
        fmt::print(stderr, "poissonlab: note: heights end before circumference {}: {}\n", circumference + 1,
                   error.what());
        return known;
    }
}

void verify_aperiodic(const AperiodicVerifyOptions& options)
{
    std::filesystem::path out;
    if (!options.out.empty()) out = checked_output("aperiodic verify", "--out", options.out, picture_formats());
    const ChosenTiles chosen = constructed_tiles("aperiodic verify", options);
    if (!options.as_json) {
        if (chosen.corners)
            fmt::print("{}: {} corner tiles over {} colours\n", chosen.name, chosen.corners->tiles.size(),
                       chosen.corners->colors);
        else
            fmt::print("{}: {} Wang tiles over {} colours\n", chosen.name, chosen.wang.tiles.size(),
                       color_count(chosen.wang));
        fmt::print("circumference      rows   columns\n");
    }
    const PeriodSearch search = searched(chosen.wang, options);
    if (search.period && !out.empty()) draw_period(out, chosen, *search.period);
    if (options.as_json)
        print_outcome_json(search, chosen.name, options.width);
    else
        print_outcome(search, options.width);
}

}

Command aperiodic_verify_command()
{
    const auto o = std::make_shared<AperiodicVerifyOptions>();
    return {"verify",
            "Search for periods of a tile set",
            {{"SET", &o->set, aperiodic_set_help},
             {"--construction", &o->construction, "Search the corner tiles of aperiodic convert instead", "NAME"},
             allowing({"--repeat", &o->repeat, "How often that construction; default: 1", "K"},
                      Integers{1, most_repetitions}),
             allowing({"--width", &o->width, "The largest circumference of cylinders, in tiles", "W", required},
                      Integers{1, largest_width}),
             {"--out", &o->out, "Where a tiling that repeats is drawn (.svg, .png)", "FILE"},
             json_option(o->as_json)},
            aperiodic_verify_notes,
            action_on(o, verify_aperiodic)};
}

}
