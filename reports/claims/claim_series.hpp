// The series of a report as the paper's claims ask for them, and what these say of a series.
#pragma once

#include "reports/layout/report_layout.hpp"
#include "results/pictures/distribution_result.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// The points of the sets of chapter 6: of those with spectra, and of those that sample the zone plate.
inline constexpr std::size_t usual_points = 16384;
inline constexpr std::size_t plate_points = 262144;

/// The series that a claim is about.
struct SeriesQuery
{
    enum class Needs
    {
        anything,
        spectrum, ///< an estimate of several realizations, or the periodogram of a deterministic method
        plate,    ///< the zone plate
        iterations,
    };

    std::string sampler;
    std::map<std::string, double> numbers = {}; ///< parameters with their values
    std::optional<std::size_t> points = {};     ///< within a tenth: tilings hit the number of points nearly
    int dimension = 2;
    Needs needs = Needs::anything;
};

/// All series, distributions and schemes of a report.
class ClaimSeries
{
public:
    /// Looks for false rings in all pictures of the zone plate. Throws InputError for those that cannot be read.
    explicit ClaimSeries(std::vector<const ReportSeries*> series,
                         std::vector<const DistributionResult*> distributions = {});

    /// Every series that lies in no region, whichever its method.
    const std::vector<const ReportSeries*>& series() const { return series_; }

    /// True where a method tiles, and where there are distributions or schemes: claims about tiles look at nothing
    /// else.
    bool has_tiles() const;

    std::vector<const ReportSeries*> all(const SeriesQuery& query) const;

    /// The first one, or nullptr.
    const ReportSeries* one(const SeriesQuery& query) const;

    /// The distributions (schemes) of a kind.
    std::vector<const DistributionResult*> distributions(const std::string& kind) const;

    /// A number of the first scheme of a kind that has it.
    std::optional<double> scheme_number(const std::string& kind, const std::string& key) const;

    /// The samplers whose series were asked for since this was called last, in that order, each once.
    std::vector<std::string> take_asked() const { return std::exchange(asked_, {}); }

    /// The strength of the false rings in the zone plate of a series; empty where there is no plate of enough pixels.
    struct Rings
    {
        double strength = 0, at_the_plate = 0, bound = 0;
    };
    std::optional<Rings> false_rings(const ReportSeries& series) const;

private:
    /// Notes the sampler of a query: so the methods that a claim is about follow from what it looks at.
    void note(const SeriesQuery& query) const;

    std::vector<const ReportSeries*> series_;
    std::vector<const DistributionResult*> distributions_;
    std::map<const ReportSeries*, Rings> rings_;
    mutable std::vector<std::string> asked_;
};

/// The false rings in the zone plates of series that have plates of enough pixels. Throws InputError for pictures that
/// cannot be read.
std::map<const ReportSeries*, ClaimSeries::Rings> rings_in_plates(const std::vector<const ReportSeries*>& series);

/// A number of a distribution by its key; with its error, where it is a mean over several sets.
std::optional<double> number_of(const DistributionResult& distribution, const std::string& key);
std::optional<Estimate> estimate_in(const DistributionResult& distribution, const std::string& key);

/// A parameter as a number: what was given, or the stored default.
std::optional<double> number_parameter(const ReportSeries& series, const std::string& key);

/// A parameter as it is shown, given or by default; empty: there is none.
std::string text_parameter(const ReportSeries& series, const std::string& key);

/// Tiles in the set: C^4, C^12, T, or C^8 (3D).
std::optional<double> tiles_of_set(const ReportSeries& series);

/// A measure by its key; nullptr where the series does not have it.
const Estimate* estimate_of(const ReportSeries& series, const std::string& key);

/// True for spectra that are estimates, not a single periodogram of sets that differ.
bool has_estimated_spectrum(const ReportSeries& series);

/// The number of tile sets that the realizations of a series take in turn; 1 for methods without such a parameter.
int tile_sets_of(const ReportSeries& series);

/// The root mean square error of the zone plate where it has between `low` and `high` cycles per pixel.
double plate_error(const ReportSeries& series, double low, double high);

}
