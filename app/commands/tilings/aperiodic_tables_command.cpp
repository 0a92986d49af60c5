// poissonlab aperiodic tables: the dissertation's tables 8.1 to 8.7 beside what is computed, as docs/aperiodic-tiles.md
// has them.
#include "app/commands/work_options.hpp"
#include "tiles/aperiodic/table_comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

constexpr auto aperiodic_tables_notes =
    R"(Computes every number of the tables for the sets that are available, and searches all of their corner tiles for
periods. The page docs/aperiodic-tiles.md is what this prints.
  poissonlab aperiodic tables)";

constexpr std::size_t searched_width = 6;

constexpr auto tables_head =
    R"(# Aperiodic sets of corner tiles: the tables of the dissertation, computed

Lagae, *Tile-Based Methods in Computer Graphics*, 2007, chapter 8, makes sets of corner tiles of aperiodic sets of Wang
tiles, and Wang tiles of those again. This page is what `poissonlab aperiodic tables` prints: every number of tables 8.1
to 8.7 that can be computed, beside the one that is printed there. A cell is tiles/colours of corner tiles and, in
brackets, the colours of the Wang tiles made of them, of which there are as many. The first rows are tables 8.1 and 8.2.

The sets of 24 and 32 Wang tiles are printed as pictures only (Grünbaum and Shephard, *Tilings and Patterns*, page 593).
That of 24 tiles, Robinson's, is derived anew, as the end of this page says, and all numbers that are printed of it come
out. That of 32 tiles, Penrose's, is not available, and its column is not checked. "Failed" is explained by what is
counted: several patterns of Wang tiles give the same corner tile, so that corner tiles do not tell the Wang tiles they
come from. The dissertation gives no reason.
)";

constexpr auto derivations =
    R"(
## The sets of 24 and 32 Wang tiles

**24 tiles.** In a tiling with Ammann's two L-shaped tiles A2, some edges end at two junctions of three tiles and lie
between two large tiles. When each of these is shrunk to one of its ends, tiles have four neighbours each and lie in a
square grid, one Wang tile for each. Such edges are straight or L-shaped, and each kind has two ends. Two of the four
choices give 24 tiles with 12 colours of horizontal edges and 12 of vertical ones, if sides have the same colour only
where the tiling makes them meet, and one of the two gives the printed numbers: all 57, from 203 to 7,092 corner tiles. So
this is Robinson's set up to the names of colours, and reflections, as far as numbers can tell. The dissertation counts
its colours as 24. The script `tests/tiles/aperiodic/robinson_tiles.py` derives the set with exact numbers. The 62 corner
tiles that the horizontal construction makes of it, in tables 8.1 and 8.4, are not aperiodic: they have a tiling that
repeats 2 × 1 tiles, moved by one tile from row to row, which
`poissonlab aperiodic verify robinson --construction horizontal --width 2` finds.

**32 tiles.** The dissertation says that they come of cutting up a tiling with Penrose's kites and darts, and no more. The
table lists what was tried, with colours as above. None has the printed 32 tiles, 28 colours of both kinds of edges, 114
squares of 2 × 2 tiles, and 58 black tiles. These tries are not kept as programs: nothing here computes the table again.

| grid | Wang tiles | colours of horizontal, vertical edges | squares of 2 × 2 tiles | black tiles |
| --- | --- | --- | --- | --- |
| Ammann bars of two neighbouring directions | 24 | 10, 10 | 100 | 42 |
| Ammann bars of two other directions | 38 | 14, 14 | 236 | 56 |
| neighbouring directions, with paths along kites and darts, and edges of both paths shrunk to an end: eight choices | 34, 35, 36, 37, 40 | 15 to 20 of each | 124 to 184 | 52 to 66 |
| neighbouring directions, with marks at vertices of kites and darts, 2,116 choices: the two nearest ones | 28, 34 | 14, 12 and 18, 16 | 114, 118 | 46, 58 |
)";

constexpr auto periods_head =
    R"(
## Periods

Rows that close after w tiles are stacked until nothing fits, for all w up to {} and along both axes. Where stacks have no
end, the set has a tiling that repeats. **No finite search proves that a set is aperiodic**: there may be a longer period.
Sets made by the diagonal, rotation and subdivision constructions, and by the vertical one of Kari's set, tell the Wang
tiles that they are made of, and are aperiodic as those are.

The dissertation calls 44 tiles over 6 colours (figure 8.6, of Ammann's 16 Wang tiles by the horizontal construction) the
smallest aperiodic set of corner tiles known. Every number that it prints of this set is the same here, and the set tiles
a torus of 2 × 3 tiles: `poissonlab aperiodic verify ammann --construction horizontal --width 2`. Of the sets here
without a period, the smallest are the 40 corner tiles over 8 colours that the rotation makes of Jeandel and Rao's Wang
tiles, which were found later; of those that the dissertation could know, the 49 of Ammann's by the same construction.
Jeandel and Rao's set is here with four colours. Others list it with five: there horizontal colour 0 is two, 0 and 4,
which its authors merge without a period.

Smaller aperiodic sets of corner tiles are published: Nurmi (*Bridges 2016*, pages 159 to 166) has one of 30 tiles. T.
Schlömer's dissertation (*Non-Periodic Corner Tilings in Computer Graphics*, Konstanz 2012) treats tilings with corner tiles
and their combinatorial problems; its text was not at hand. The sets of this page are those that the constructions above
make, and none of them is called new or smallest.

| Wang tiles | construction | corner tiles/colours | |
| --- | --- | --- | --- |
)";

std::string text_of(const PrintedStep& step)
{
    return fmt::format("{}/{}{}", step.tiles, step.colors,
                       step.wang_colors > 0 ? fmt::format(" [{}]", step.wang_colors) : "");
}

/// The cell shows the printed number, and the computed one beside it where they differ.
std::string cell_of(const ComparedColumn& column, std::size_t step)
{
    if (column.printed.steps.empty()) {
        if (step > 0) return "";
        if (!column.here) return "failed, not checked";
        const std::size_t tiles = column.here->front().tiles;
        return fmt::format("failed{}: {} patterns, {} tiles", column.agrees() ? "" : ", but not here", column.patterns,
                           tiles);
    }
    const std::string printed = text_of(column.printed.steps[step]);
    if (!column.here) return printed + ", not checked";
    const std::string here = text_of(column.here->at(step));
    return printed == here ? printed : printed + ", **here " + here + "**";
}

void print_table(const std::string& table, const std::vector<ComparedColumn>& all)
{
    std::vector<ComparedColumn> columns;
    std::ranges::copy_if(all, std::back_inserter(columns),
                         [&](const ComparedColumn& column) { return column.printed.table == table; });
    fmt::print("\n## Table {}: {}, repeated\n\n|", table, corner_constructions[columns.front().printed.construction]);
    for (const ComparedColumn& column : columns) fmt::print(" {} |", column.printed.set);
    fmt::print("\n|");
    std::size_t steps = 0;
    for (const ComparedColumn& column : columns) {
        fmt::print(" --- |");
        steps = std::max(steps, column.printed.steps.size());
    }
    fmt::print("\n");
    for (std::size_t step = 0; step < steps; ++step) {
        fmt::print("|");
        for (const ComparedColumn& column : columns) fmt::print(" {} |", cell_of(column, step));
        fmt::print("\n");
    }
    for (const ComparedColumn& column : columns)
        if (column.printed.white > 0)
            fmt::print("\n{}: {} white and {} black tiles{}", column.printed.set, column.printed.white,
                       column.printed.black,
                       !column.here      ? ", not checked."
                       : column.agrees() ? ", here the same."
                                         : fmt::format(", **here {} and {}**.", column.white, column.black));
    if (columns.front().printed.white > 0) fmt::print("\n");
}

void print_periods()
{
    fmt::print(periods_head, searched_width);
    for (const SearchedColumn& column : search_constructions(searched_width)) {
        const auto& period = column.search.period;
        fmt::print("| {} | {} | {}/{} | {} |\n", column.title, corner_constructions[column.construction],
                   column.corners.tiles.size(), column.corners.colors,
                   period ? fmt::format("{} × {} tiles repeat", period->width, period->height)
                          : fmt::format("no period up to {}", searched_width));
    }
}

nlohmann::ordered_json json_of_steps(const std::vector<PrintedStep>& steps)
{
    auto json = nlohmann::ordered_json::array();
    for (const PrintedStep& step : steps)
        json.push_back({{"tiles", step.tiles}, {"colors", step.colors}, {"wang_colors", step.wang_colors}});
    return json;
}

void print_tables_json(const std::vector<ComparedColumn>& columns)
{
    nlohmann::ordered_json json{{"tables", nlohmann::ordered_json::array()},
                                {"searched_width", searched_width},
                                {"periods", nlohmann::ordered_json::array()}};
    for (const ComparedColumn& column : columns) {
        nlohmann::ordered_json row{{"table", column.printed.table},
                                   {"set", column.printed.set},
                                   {"construction", corner_constructions[column.printed.construction]},
                                   {"printed", json_of_steps(column.printed.steps)}};
        row["here"] = column.here ? json_of_steps(*column.here) : nlohmann::ordered_json();
        if (column.here) row["agrees"] = column.agrees();
        json["tables"].push_back(std::move(row));
    }
    for (const SearchedColumn& column : search_constructions(searched_width)) {
        nlohmann::ordered_json row{{"set", column.title},
                                   {"construction", corner_constructions[column.construction]},
                                   {"tiles", column.corners.tiles.size()},
                                   {"colors", column.corners.colors},
                                   {"period", nullptr}};
        if (const auto& period = column.search.period) row["period"] = {period->width, period->height};
        json["periods"].push_back(std::move(row));
    }
    fmt::print("{}\n", json.dump(2));
}

void print_tables(const bool& as_json)
{
    const std::vector<ComparedColumn> columns = compare_tables();
    if (as_json) return print_tables_json(columns);
    fmt::print("{}", tables_head);
    for (const char* table : {"8.3", "8.4", "8.7", "8.5", "8.6"}) print_table(table, columns);
    print_periods();
    fmt::print("{}", derivations);
}

}

Command aperiodic_tables_command()
{
    const auto as_json = std::make_shared<bool>(false);
    return {"tables",
            "Compare the dissertation's tables 8.1 to 8.7 with what is computed",
            {json_option(*as_json)},
            aperiodic_tables_notes,
            action_on(as_json, print_tables)};
}

}
