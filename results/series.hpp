// One series of a run: N points, K realizations of one method with one set of parameters, and what was measured.
//
// The iterations of a series: as a table of all realizations, and averaged over them.
#pragma once

#include "analysis/measures/blue_noise_measures.hpp"
#include "analysis/measures/integration_error.hpp"
#include "analysis/measures/largest_empty_ball.hpp"
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/measures/low_frequency_power.hpp"
#include "analysis/measures/peak_anisotropy.hpp"
#include "analysis/measures/voronoi_diagram.hpp"
#include "base/geometry/periodic_box.hpp"
#include "results/blue_noise.hpp"
#include "results/method_grid.hpp"
#include "results/records/sample_records.hpp"
#include "results/statistic.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// One list of records a realization, which may differ in length.
using IterationRecords = std::vector<std::vector<IterationRecord>>;

/// The text of iterations.csv: realization,iteration,relative_radius,energy, and relative_radius_within_tiles where all
/// records have it; 17 significant digits.
std::string iterations_csv(const IterationRecords& records);

/// Reads what iterations_csv() wrote. Throws InputError with file and line.
IterationRecords read_iterations_table(const std::filesystem::path& path);

/// A quantity after each iteration, over the realizations that got there.
struct IterationSpread
{
    std::vector<double> min;
    std::vector<double> mean;
    std::vector<double> max;

    bool operator==(const IterationSpread&) const = default;
};

/// The iterations of a method that has some; item 0 is the state before the first one.
struct Iterations
{
    std::string file;                      ///< relative to the run's folder
    std::vector<std::size_t> realizations; ///< how many got to each iteration: never growing; empty: without means
    IterationSpread relative_radius;
    IterationSpread energy;
    std::optional<IterationSpread> relative_radius_within_tiles; ///< of tiles that are relaxed

    bool operator==(const Iterations&) const = default;

    /// The largest number of iterations of a realization.
    std::size_t count() const { return realizations.size() - 1; }
};

/// Means over all realizations, without the file. Nothing where there are no iterations; without means where a value is
/// not finite (a single point has no relative radius).
std::optional<Iterations> iterations_of(const IterationRecords& records);

// The border of sets that were made elsewhere, which may not be periodic: see analysis/borders/border_pairs.hpp.

struct Series;

/// The finding on a series' border.
struct BorderResult
{
    std::uint64_t pairs_across = 0;   ///< of all sets, closer than the closest pair inside
    double chance = 1;                ///< of as many or more of periodic sets
    double relative_radius = 0;       ///< within the square (cube): of the closest pair inside, the mean over the sets
    double mean_nearest_distance = 0; ///< within the square (cube), of the largest possible distance

    bool operator==(const BorderResult&) const = default;

    /// True where the closest pairs meet across the border more often than chance allows.
    bool is_not_periodic() const;
};

/// A sentence or two for readers of a series whose sets are not periodic, without the program's own words for the way
/// out; empty for others.
std::string border_words(const Series& series);

/// The way to measure such sets, in the words of the command line, of configs and of Python.
std::string border_advice(int dimension);

/// A sentence or two for readers of a series from files whose sets differ from each other more than sets of one method
/// do, by the mean distance to the nearest point; empty for others.
std::string mixture_words(const Series& series);

class JsonMembers;

/// The sampling test: the picture of the first realization, and errors over all.
struct ZonePlateResult
{
    int size = 0;           ///< pixels along each axis
    std::string file;       ///< relative to the run's folder, like all files here
    std::string error_file; ///< the error over the distance
    Statistic rms_error;
    std::optional<Statistic> resolved_rms_error; ///< where the plate has up to half a cycle per pixel

    bool operator==(const ZonePlateResult&) const = default;
};

/// The density of a tiling's points over the tile, as an image.
struct FoldedDensityFile
{
    int size = 0;     ///< bins along each axis
    std::string file; ///< relative to the run's folder

    bool operator==(const FoldedDensityFile&) const = default;
};

/// The periodic box of sets that lie in no square (cube). Lengths of results are in roots of its area (volume).
struct BoxResult
{
    std::vector<double> sides; ///< two or three, as they were given

    double unit_length() const; ///< of the results' lengths, in the unit of the sides
    PeriodicBox box() const;

    bool operator==(const BoxResult&) const = default;
};

/// The region of the plane that sets lie in.
struct RegionResult
{
    std::string name;       ///< as it was typed, files without their folder
    double area = 0;        ///< in squares of its units
    double unit_length = 1; ///< of the results' lengths, in its units: the root of the area
    double perimeter = 0;   ///< with that of holes, in its units; 0: not known, as in older results
    std::size_t polygons = 0, corners = 0;
    bool is_in_metres = false;      ///< longitude and latitude were mapped to a plane, whose units are metres
    bool has_density = false;       ///< K and g are those of points that follow a density
    std::size_t envelope = 0;       ///< random sets of the envelopes
    std::size_t tapers = 0;         ///< that spectra are means over; 0: of the points less the region's
    double covariance_error = 0;    ///< of the table of the set covariance, as a share of the area; 0: there was none
    std::vector<std::string> notes; ///< on what was made of its file, a sentence each
    std::string file;               ///< curves, relative to the run's folder; empty: of sets of one point
    std::string picture_file;       ///< the first set in the region, marks; empty: none was made

    bool operator==(const RegionResult&) const = default;
};

/// A number that stands for all realizations, or for the first one.
struct Estimate
{
    double value = 0;
    std::optional<double> standard_error; ///< over the realizations, where there are several

    bool operator==(const Estimate&) const = default;
};

/// The member "measures": all but distances and what files hold. Nothing: not defined for the sets at hand.
struct Measures
{
    /// Measures that are one number each, by their keys in the catalogue, see measures.hpp.
    std::map<std::string, Estimate> numbers;

    std::optional<Oscillation> oscillation;
    std::optional<PeakAnisotropy> peak_anisotropy;
    std::optional<LowFrequencyPower> low_frequency_power;
    std::optional<LatticePeaks> lattice_peaks;     ///< of sets that are tiled
    std::vector<IntegrationError> integration;     ///< over all realizations
    std::optional<LargestEmptyBall> largest_empty; ///< of the first realization
    std::optional<VoronoiStatistics> voronoi;      ///< of the first realization, 2D

    bool operator==(const Measures&) const = default;
};

/// Names and values in the order in which they are shown.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

struct Series
{
    std::string name; ///< its folder
    std::string label;
    std::string sampler;
    std::string parameters_json = "{}"; ///< those that were given, an object as results.json has it
    std::string defaults_json;          ///< the others, empty where there are none; results of older versions have none
    NamedTexts parameters;              ///< both as shown; what is read has texts and objects
    NamedTexts defaults;
    std::optional<GridPlace> place; ///< in the grid of its method; none: not of a method of a config
    bool deterministic = false;
    bool is_window = false;               ///< sets are windows of the plane, not tori, and were measured as such
    std::size_t points = 0;               ///< N of each realization; their mean where sizes differ
    std::vector<std::size_t> points_each; ///< only where sizes differ: the size of each
    int realizations = 0;                 ///< K, the sets: each another one
    std::vector<std::size_t> repeated; ///< numbers of further realizations that are one of these sets: without results
    std::optional<Statistic> min_distance; ///< unit lengths; empty for one point
    std::optional<Statistic> relative_radius;
    std::optional<Statistic> covered_fraction;
    Measures measures;
    std::optional<BlueNoiseVerdict> blue_noise; ///< whether sets are that
    std::optional<BorderResult> border;         ///< of sets that were made elsewhere and measured as periodic
    bool is_estimate = false;                   ///< true: "power spectrum estimate", false: "periodogram"
    int spectrum_size = 0;                      ///< frequency samples along each axis
    std::string spectrum_file;                  ///< empty: not stored
    std::string volume_file;                    ///< all of a 3D spectrum; empty: not stored
    std::string radial_file;                    ///< empty: no spectrum was made
    double background_anisotropy_db = 0;
    std::string pair_correlation_file;               ///< empty: sets of one point
    std::string number_variance_file;                ///< empty: sets of a few points
    std::optional<FoldedDensityFile> folded_density; ///< of tilings of the plane
    std::optional<BoxResult> box;                    ///< of sets on the torus of a rectangle or a box
    std::optional<RegionResult> region;              ///< of sets in a region, not on the torus
    std::optional<Iterations> iterations;
    std::optional<ZonePlateResult> zone_plate;
    std::vector<std::string> point_files;  ///< none of sets that were read in pieces
    std::optional<TileSetRecord> tile_set; ///< of methods that tile
    std::vector<double> sample_seconds;    ///< of timed runs; at least one a realization, but for imported sets
    std::size_t device_bytes = 0;          ///< the most that sampling takes of a device; 0: it needs none
    double build_seconds = 0;              ///< of kernels
    double preparation_seconds = 0;        ///< of what all realizations share
    double analysis_seconds = 0;

    bool operator==(const Series&) const = default;

    bool has_spectrum() const { return !radial_file.empty(); }

    /// The number of points of the first realization, the one that is drawn.
    std::size_t points_of_first() const { return points_each.empty() ? points : points_each.front(); }

    /// True for a realization, by its number, that is one of the sets of earlier ones.
    bool is_repeated(std::size_t realization) const;

    /// Sets the numbers of realizations and points.
    void set_sizes(const std::vector<std::size_t>& sizes);
};

/// True for a parameter that is a density which points follow: one that is a number is everywhere the same.
bool is_followed_density(const std::string& key, const std::string& text);

/// The frequency up to which a series' spectrum has all directions, in cycles per unit length.
double spectrum_reach(const Series& series);

/// These list the members of series and measures in results.json, see json_members.hpp.
void members(JsonMembers& m, const Series& series);
void members(JsonMembers& m, Series& series);
void members(JsonMembers& m, const Measures& measures);
void members(JsonMembers& m, Measures& measures);

/// Measures as a JSON text, and back. Throws InputError for texts of another kind.
std::string measures_text(const Measures& measures);
Measures read_measures(const std::string& text);

}
