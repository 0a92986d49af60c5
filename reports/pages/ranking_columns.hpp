// The columns of the ranking: a quantity is its name, its unit, which way is better, and where its value is.
#pragma once

#include "reports/layout/site.hpp"
#include "results/better.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// What a series has in a column.
struct RankingCell
{
    double value = 0;   ///< as in results.json, or computed from what is there
    std::string shown;  ///< rounded
    std::string spread; ///< "± 0.01" or "0.74 to 0.76"; empty: none
};

struct RankingColumn
{
    std::string key;
    std::string title;
    std::string unit; ///< empty: a pure number
    Better better = Better::neither;
    bool is_time = false; ///< compares on one machine only
    std::string meaning;  ///< a sentence or two, for readers
    std::function<std::optional<RankingCell>(const ReportSeries&)> cell;
};

/// All of them, in the order of the table.
const std::vector<RankingColumn>& ranking_columns();

/// Those that at least one of the series has a value in.
std::vector<const RankingColumn*> columns_of(const std::vector<const ReportSeries*>& series);

}
