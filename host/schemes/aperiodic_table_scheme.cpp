// kind = "aperiodic-tables": tables 8.1 to 8.7 of the dissertation beside what is computed, and the search for periods.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 8.3 and 8.4.
#include "host/schemes/mark_canvas.hpp"
#include "host/schemes/scheme_run.hpp"
#include "tiles/aperiodic/table_comparison.hpp"

#include <fmt/format.h>

#include <array>

namespace poissonlab {
namespace {

/// "125/13 [50]".
std::string step_words(const PrintedStep& step)
{
    return fmt::format("{}/{}{}", step.tiles, step.colors,
                       step.wang_colors > 0 ? fmt::format(" [{}]", step.wang_colors) : "");
}

struct Tallies
{
    double numbers = 0, same = 0; ///< of the numbers that can be computed
    double unavailable = 0;
};

void add_row(DistributionTable& table, Tallies& tallies, const std::string& set, const std::string& step,
             const std::string& printed, const std::string& here, int numbers)
{
    if (here.empty()) {
        tallies.unavailable += numbers;
        table.rows.push_back({set, step, printed, "not available", "-"});
        return;
    }
    const bool is_same = printed == here;
    tallies.numbers += numbers;
    tallies.same += is_same ? numbers : 0;
    table.rows.push_back({set, step, printed, here, is_same ? "the same" : "not the same"});
}

void add_column(DistributionTable& table, Tallies& tallies, const ComparedColumn& column)
{
    const std::string& set = column.printed.set;
    if (column.printed.steps.empty()) {
        const bool failed = column.here && column.patterns > column.here->front().tiles;
        table.rows.push_back({set, "1", "failed",
                              !column.here ? "not available"
                                           : fmt::format("{} patterns of Wang tiles give {} corner tiles",
                                                         column.patterns, column.here->front().tiles),
                              !column.here ? "-"
                              : failed     ? "explained"
                                           : "not explained"});
        return;
    }
    for (std::size_t i = 0; i < column.printed.steps.size(); ++i) {
        const PrintedStep& printed = column.printed.steps[i];
        add_row(table, tallies, set, fmt::format("{}", i + 1), step_words(printed),
                column.here ? step_words(column.here->at(i)) : "", printed.wang_colors > 0 ? 3 : 2);
    }
    if (column.printed.white > 0)
        add_row(table, tallies, set, "1, white + black",
                fmt::format("{} + {}", column.printed.white, column.printed.black),
                column.here ? fmt::format("{} + {}", column.white, column.black) : "", 2);
}

DistributionTable period_table(const std::vector<SearchedColumn>& searched, std::size_t width)
{
    DistributionTable table{
        fmt::format("Periods up to {} tiles along either axis. No finite search proves that a set is "
                    "aperiodic: there may be a longer period",
                    width),
        {"Wang tiles", "construction", "corner tiles/colours", "found"},
        {}};
    for (const SearchedColumn& column : searched) {
        const auto& period = column.search.period;
        table.rows.push_back({column.title, corner_constructions[column.construction],
                              fmt::format("{}/{}", column.corners.tiles.size(), column.corners.colors),
                              period ? fmt::format("{} x {} tiles repeat", period->width, period->height)
                                     : fmt::format("no period up to {}", width)});
    }
    return table;
}

/// A part of the tiling from the north-west of a period, which has a frame.
MarkPicture torus_picture(const CornerList& corners, const PeriodicTiling& period)
{
    constexpr std::size_t shown = 6;
    constexpr double margin = 0.2;
    const double side = shown + 2 * margin;
    MarkCanvas canvas(side, side, 70);
    const auto place = [&](std::size_t x, std::size_t y) {
        return MarkPoint{margin + static_cast<double>(x), side - margin - static_cast<double>(y)};
    };
    for (std::size_t y = 0; y < shown; ++y)
        for (std::size_t x = 0; x < shown; ++x)
            canvas.tile(corners.tiles[period.at(x, y)], MarkSquare{place(x, y + 1)}, 0.02);
    canvas.outline("#000000",
                   {place(0, 0), place(period.width, 0), place(period.width, period.height), place(0, period.height)},
                   0.1);
    return canvas.picture();
}

/// The set that the dissertation calls the smallest, and the smallest of those without a period that was found.
void add_smallest(const std::vector<SearchedColumn>& searched, std::size_t width, DistributionFiles& files,
                  DistributionResult& result)
{
    const SearchedColumn* smallest = nullptr;
    for (const SearchedColumn& column : searched) {
        const bool is_known_then = !column.title.starts_with("Jeandel");
        if (!column.search.period && is_known_then &&
            (!smallest || column.corners.tiles.size() < smallest->corners.tiles.size()))
            smallest = &column;
        if (!column.title.starts_with("Ammann") || column.construction != CornerConstruction::horizontal) continue;
        const auto& period = column.search.period;
        result.numbers.push_back({"claimed_tiles", "Set of figure 8.6, tiles",
                                  static_cast<double>(column.corners.tiles.size()), "the dissertation's smallest"});
        result.numbers.push_back({"claimed_period_width", "Its period: width",
                                  static_cast<double>(period ? period->width : 0),
                                  fmt::format("tiles; 0: none up to {}", width)});
        result.numbers.push_back(
            {"claimed_period_height", "Its period: height", static_cast<double>(period ? period->height : 0), "tiles"});
        if (period)
            files.add_marks("torus.json", torus_picture(column.corners, *period),
                            fmt::format("The set of figure 8.6 tiles a torus of {} x {} tiles, framed, and so repeats.",
                                        period->width, period->height),
                            result);
    }
    if (smallest)
        result.numbers.push_back({"smallest_tiles", "Smallest set without a period that was found",
                                  static_cast<double>(smallest->corners.tiles.size()),
                                  fmt::format("{}, {}; of the sets that were known in 2007", smallest->title,
                                              corner_constructions[smallest->construction])});
}

}

DistributionResult make_aperiodic_tables(const AperiodicTableSettings& settings, DistributionFiles& files)
{
    constexpr std::array tables{"8.3", "8.4", "8.7", "8.5", "8.6"};
    DistributionResult result;
    Tallies tallies;
    const std::vector<ComparedColumn> columns = compare_tables();
    for (const char* const name : tables) {
        DistributionTable table{"", {"Wang tiles/colours", "step", "D", "here", ""}, {}};
        for (const ComparedColumn& column : columns) {
            if (column.printed.table != name) continue;
            table.title =
                fmt::format("Table {}, {} construction: tiles/colours of corner tiles, and colours of the Wang "
                            "tiles made of them in brackets; first steps are tables 8.1 and 8.2",
                            name, corner_constructions[column.printed.construction]);
            add_column(table, tallies, column);
        }
        result.tables.push_back(std::move(table));
    }
    const auto searched = search_constructions(settings.width);
    result.tables.push_back(period_table(searched, settings.width));
    result.facts = {"the set of 32 Wang tiles is printed as a picture in a book only and is not available",
                    "\"failed\" is explained where several patterns of Wang tiles give the same corner tile: the "
                    "dissertation gives no reason"};
    result.numbers = {{"numbers", "Numbers compared", tallies.numbers, "of tables 8.1 to 8.7"},
                      {"same", "Numbers that are the same", tallies.same, ""},
                      {"unavailable", "Numbers not available", tallies.unavailable, "of the set 32/16"}};
    add_smallest(searched, settings.width, files, result);
    return result;
}

}
