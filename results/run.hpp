// The results of a run as they lie on disk: results.json of docs/output-folder.md, checked.
#pragma once

#include "results/iteration_records.hpp"
#include "results/measures.hpp"
#include "results/method_grid.hpp"
#include "results/pictures/stored_constructions.hpp"
#include "results/pictures/stored_tilings.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// A quantity over the realizations of a series.
struct Statistic
{
    double min = 0;
    double mean = 0;
    double max = 0;
    std::vector<double> each; ///< of every realization; empty: not stored
};

/// The iterations of a method that has some; item 0 is the state before the first one.
struct Iterations
{
    std::string file;
    std::vector<double> realizations; ///< how many got to each iteration
    IterationSpread relative_radius;
    IterationSpread energy;

    /// The largest number of iterations of a realization.
    std::size_t count() const { return realizations.size() - 1; }
};

/// The sampling test: the picture of the first realization, and errors over all.
struct StoredZonePlate
{
    int size = 0; ///< pixels along each axis
    std::string file;
    std::string error_file;
    Statistic rms_error;
    std::optional<Statistic> resolved_rms_error; ///< where the plate has up to half a cycle per pixel
};

/// The points of a tile in the regions of its corners, edges, faces or in its interior; means over a tile set.
struct StoredRegion
{
    std::string name; ///< "corners", "edges", "faces", "interior"
    double points = 0;
    double expected = 0; ///< as many as the area (volume) of the regions holds
};

/// The tile set of a series, and how long it took to build, which may have been in an earlier run.
struct StoredTileSet
{
    std::int64_t tiles = 0;
    std::int64_t points_per_tile = 0;
    std::optional<double> build_seconds; ///< empty: not known
    std::string device;
    bool cached = false;               ///< read from the cache this time
    std::vector<StoredRegion> regions; ///< empty: of templates
};

/// Names and values in the order in which they are shown.
using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// One series: N points, K realizations of one method with one set of parameters.
struct Series
{
    std::string name; ///< its folder
    std::string label;
    std::string sampler;
    NamedTexts parameters;             ///< those that were given
    NamedTexts defaults;               ///< the others; results of older versions have none
    std::optional<std::size_t> method; ///< which of the run's methods it is of
    std::vector<std::size_t> place;    ///< its index on each axis of that
    bool deterministic = false;
    std::size_t points = 0;               ///< N of each realization; their mean where sizes differ
    std::vector<std::size_t> points_each; ///< only where sizes differ: the size of each
    int realizations = 0;
    std::optional<Statistic> min_distance; ///< unit lengths; empty for one point
    std::optional<Statistic> relative_radius;
    std::optional<Statistic> covered_fraction;
    bool is_estimate = false;  ///< true: "power spectrum estimate", false: "periodogram"
    int spectrum_size = 0;     ///< frequency samples along each axis
    std::string spectrum_file; ///< relative to the folder, like all files here; empty: not stored
    std::string volume_file;   ///< all of a 3D spectrum; empty: not stored
    std::string radial_file;   ///< empty: no spectrum was made
    double background_anisotropy_db = 0;
    std::string pair_correlation_file; ///< empty: sets of one point
    std::optional<Iterations> iterations;
    std::optional<StoredZonePlate> zone_plate;
    Measures measures;
    std::vector<std::string> point_files;
    std::vector<double> sample_seconds; ///< of timed runs; at least one a realization, but for imported sets
    double build_seconds = 0;
    std::optional<StoredTileSet> tile_set;

    bool has_spectrum() const { return !radial_file.empty(); }

    /// The number of points of the first realization, the one that is drawn.
    std::size_t points_of_first() const { return points_each.empty() ? points : points_each.front(); }
};

/// One result folder.
struct Run
{
    std::filesystem::path folder;
    std::string title;
    std::string version;
    std::string command;
    std::string config; ///< verbatim; empty for imported point sets
    std::vector<std::string> overrides;
    std::string seed;   ///< as stored; empty when there is none
    std::string engine; ///< "opencl" or "reference"; empty when nothing was sampled
    int dimension = 2;
    NamedTexts machine;              ///< the members of "machine" that are there
    std::vector<MethodGrid> methods; ///< empty: not known, as in imported results
    std::vector<Series> series;
    std::vector<TilingResult> tilings;             ///< and tile sets
    std::vector<ConstructionResult> constructions; ///< at least one of these, or a tiling or a series

    /// A member of `machine`, or an empty string.
    std::string machine_member(const std::string& name) const;
};

/// Reads and checks folder/results.json, and that the files it names are there.
/// Throws InputError that names the file and the member.
Run read_run(const std::filesystem::path& folder);

}
