// The analysis of a series, or of consecutive realizations of it, as stored units of work.
#pragma once

#include "experiment/measuring/series_analysis.hpp"
#include "experiment/store/unit_store.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace poissonlab {

/// Stores everything that was added, for load_part(). Throws StorageError.
void store_part(const SeriesAnalysis& part, UnitStore& store, const UnitKey& key);

/// Reads what store_part() stored into an analysis that was constructed alike. Returns false if it is not there, also
/// because another process removes it.
bool load_part(SeriesAnalysis& part, const UnitStore& store, const UnitKey& key);

/// Measures the means over all realizations and stores them with all images and tables. `metadata` goes into the
/// images, `iterations` is the text of iterations.csv, empty where there is none. Throws StorageError.
void store_analysis(SeriesAnalysis& series, UnitStore& store, const UnitKey& key,
                    const std::map<std::string, std::string>& metadata, const std::string& iterations);

/// A stored analysis: what was measured, and the files that go to the output folder, by name.
struct StoredAnalysis
{
    Series result;
    std::map<std::string, std::filesystem::path> files;
};

/// The stored analysis, or std::nullopt if there is none.
std::optional<StoredAnalysis> stored_analysis(const UnitStore& store, const UnitKey& key);

}
