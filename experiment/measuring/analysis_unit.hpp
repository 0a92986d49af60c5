// The analysis of consecutive realizations of a series, as a unit of work.
#pragma once

#include "experiment/measuring/series_analysis.hpp"
#include "experiment/measuring/zone_plate_analysis.hpp"
#include "experiment/store/unit_store.hpp"

#include <map>
#include <string>

namespace poissonlab {

/// Measures realizations as they come, or takes over parts that were measured before, in order.
class AnalysisUnit
{
public:
    /// The arguments are those of SeriesAnalysis.
    AnalysisUnit(const std::string& label, bool sizes_vary, const AnalysisOptions& options,
                 const SeriesAnalysis::Begin& begin)
        : options_(options), series_(label, sizes_vary, options, begin)
    {}

    void add(const PointSet& points);

    /// A set on disk, see SeriesAnalysis.
    void add(const PointStrips& points);

    /// These functions do what those of SeriesAnalysis do.
    bool repeats(const AnalysisUnit& earlier) const { return series_.repeats(earlier.series_); }
    void leave_out(const AnalysisUnit& earlier) { series_.leave_out(earlier.series_); }
    bool is_repeated(std::size_t realization) const { return series_.is_repeated(realization); }
    void append(const AnalysisUnit& next);

    /// The measures of the first realization, once all have been added.
    void measure_first() { series_.measure_first(); }

    /// Stores everything that was added, for load(). Throws StorageError.
    void store_part(UnitStore& store, const UnitKey& key) const;

    /// Takes over what store_part() stored of a unit that was constructed alike; false where it is not there, or
    /// another process removes it just now.
    bool load_part(const UnitStore& store, const UnitKey& key);

    /// Measures the means over all realizations and stores them with all images and tables. `metadata` goes into the
    /// images, `iterations` is the text of iterations.csv, empty where there is none. Throws StorageError.
    void store_analysis(UnitStore& store, const UnitKey& key, const std::map<std::string, std::string>& metadata,
                        const std::string& iterations);

    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(series_);
        if (options_.zone_plate) archive(zone_plate_);
    }

private:
    std::vector<std::string> write_spectrum_files(UnitStore& store, const UnitKey& key,
                                                  const std::map<std::string, std::string>& metadata);

    AnalysisOptions options_;
    SeriesAnalysis series_;
    ZonePlateAnalysis zone_plate_;
};

/// A stored analysis: what was measured, and the files that go to the output folder, by name.
struct StoredAnalysis
{
    Series result;
    std::map<std::string, std::filesystem::path> files;
};

/// The stored analysis, or std::nullopt if there is none.
std::optional<StoredAnalysis> stored_analysis(const UnitStore& store, const UnitKey& key);

}
