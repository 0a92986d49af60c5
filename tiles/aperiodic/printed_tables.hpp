// The sizes of tile sets that the dissertation prints: tables 8.1 to 8.7.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, chapter 8.
#pragma once

#include "tiles/aperiodic/corner_constructions.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

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

}
