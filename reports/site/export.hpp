// Results for other programs: the plots of a report for papers, and its point sets.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// The parts of results that are exported.
struct ExportParts
{
    bool plots = true;    ///< each as .csv and .tex
    bool points = true;   ///< each stored set as .csv and .usda
    bool gallery = false; ///< the tables of a gallery of reference curves: methods.csv, measures.csv, curves.csv
    bool claims = false;  ///< claims.csv: what papers claim, and what the results say of it
};

/// Writes files below `out`, in folders as a report there would have them, and named as its pictures and as the stored
/// sets. `progress` is called with a word on each step. Throws InputError for folders without readable results, and
/// StorageError; stops where the program is interrupted.
void export_results(const std::vector<std::filesystem::path>& result_folders, const std::filesystem::path& out,
                    const ExportParts& parts, const std::function<void(const std::string&)>& progress = {});

}
