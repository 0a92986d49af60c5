// The dissertation's tables 8.1 to 8.7 beside what the laboratory computes.
#pragma once

#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/corner_constructions.hpp"
#include "tiles/aperiodic/cylinder_search.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

// The sizes of tile sets that the dissertation prints: tables 8.1 to 8.7.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapter 8.

/// A set of corner tiles and the Wang tiles made from it, of which there are as many.
struct PrintedStep
{
    std::size_t tiles = 0;
    std::size_t colors = 0;
    std::size_t wang_colors = 0; ///< 0: the table ends before

    bool operator==(const PrintedStep&) const = default;
};

/// A column of a table of repeated constructions.
struct PrintedColumn
{
    std::string set; ///< "13/5": Wang tiles and colours
    CornerConstruction construction = CornerConstruction::diagonal;
    std::string table;                ///< "8.3"
    std::vector<PrintedStep> steps;   ///< empty: "failed"
    std::size_t white = 0, black = 0; ///< of the first step of a rotation (table 8.1)
};

/// All columns, table after table. The first steps are tables 8.1 and 8.2.
const std::vector<PrintedColumn>& printed_columns();

/// The tiles of a set, with colours as the dissertation counts them: of Robinson's set it numbers those of horizontal
/// and vertical edges in one sequence, so that 12 and 12 are 24.
WangList counted_tiles(const AperiodicSet& set);

/// A column of a table, with the steps as they are here; none where the set is not available.
struct ComparedColumn
{
    PrintedColumn printed;
    std::optional<std::vector<PrintedStep>> here; ///< as many as are printed, or one where that is "failed"
    std::size_t patterns = 0;                     ///< of the first step: of Wang tiles
    std::size_t white = 0, black = 0;

    /// True where all numbers are the same, and where "failed" is printed of an ambiguous step.
    bool agrees() const;
};

/// All columns of tables 8.3 to 8.7, whose first steps are those of 8.1 and 8.2; takes a second or two. Calls `on_step`
/// before each column. Throws Interrupted.
std::vector<ComparedColumn> compare_tables(const std::function<void(const PrintedColumn&)>& on_step = {});

/// The finding of a search for periods of the corner tiles of a construction.
struct SearchedColumn
{
    std::string title; ///< of the set
    CornerConstruction construction = CornerConstruction::diagonal;
    CornerList corners;
    PeriodSearch search;
};

/// Searches the corner tiles of all constructions of all sets for periods up to a width.
std::vector<SearchedColumn> search_constructions(std::size_t width);

}
