// The analysis of a series: of its realizations one after the other, or of parts of it that are put together.
#pragma once

#include "analysis/measures/hyperuniformity.hpp"
#include "analysis/measures/integration_error.hpp"
#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/measures/seam_density.hpp"
#include "analysis/measures/set_mark.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "experiment/config/analysis_options.hpp"
#include "experiment/measuring/region_series.hpp"
#include "experiment/measuring/zone_plate_analysis.hpp"
#include "results/series.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Measures as results.json has them: what is stored there is all there is to know of them.
template <class Archive>
void serialize(Archive& archive, Measures& measures)
{
    std::string text = measures_text(measures);
    archive(text);
    if constexpr (Archive::reads) measures = read_measures(text);
}

/// Collects distances, and adds up periodograms, pair correlations and errors of integrals, in the order in which
/// realizations come. The number of points and the dimension of the first one decide the size of the spectrum.
///
/// Of realizations that are the same set, wherever it lies on the torus, the first counts only: the others add nothing
/// to means, and would make errors too small.
///
/// With options.distances_only it leaves out what takes longest for large sets: pair correlation, errors of integrals,
/// the largest empty circle and Voronoi cells.
///
/// With options.tile_sets, realization k has tile set k % tile_sets, and errors are the spread between these sets, in
/// which their tilings are contained.
///
/// With options.window sets are windows of the plane, not tori: no distance goes across a border, pairs are counted as
/// often as they can be, and what is defined by the torus is left out: errors of integrals, which shift the torus, the
/// largest empty circle, Voronoi cells. The spectrum is that of the window: its border adds a cross on the axes.
///
/// With options.box_sides sets lie in a periodic box, each coordinate over its side, and lengths are in roots of its
/// area (volume): so are frequencies, in its inverse. Errors of integrals, the largest empty circle and Voronoi cells
/// are left out, and so are sets on disk.
///
/// With options.region sets lie in a region, in its units, and lengths are in roots of its area: so are frequencies, in
/// its inverse. Distances are those of the plane, the pair correlation has the translation correction, the spectrum is
/// that of points less that of the region, see region_transform.hpp, or the mean by the tapers of the region, see
/// region_tapers.hpp, whose errors are between sets, and of one set those of taper_covariance.hpp, and there are the
/// curves of region_curves.hpp.
/// The torus's measures are left out: those of windows, number variance, and laws of the lowest frequencies, which the
/// region's boundary would decide.
class SeriesAnalysis
{
public:
    /// The begin of a part of a series: realization 0, or another one if the size of realization 0 is known.
    struct Begin
    {
        std::uint32_t realization = 0;
        std::size_t points = 0; ///< of realization 0; 0: it will be added
    };

    /// `label` is for messages; `sizes_vary` as the sampler says it.
    SeriesAnalysis(std::string label, bool sizes_vary, const AnalysisOptions& options, const Begin& begin)
        : label_(std::move(label)), sizes_vary_(sizes_vary), options_(options), box_(options.box()), begin_(begin),
          region_(options.region ? make_region_series(*options.region) : nullptr)
    {}
    SeriesAnalysis(std::string label, bool sizes_vary, const AnalysisOptions& options)
        : SeriesAnalysis(std::move(label), sizes_vary, options, Begin{})
    {}

    /// Returns whether the set is another one than all before. Throws InputError for sets that are empty, of another
    /// dimension, of another size where sizes must not vary, or with points outside their region.
    bool add(const PointSet& points);

    /// Adds a set on disk, of which a few strips are in memory at a time. Numbers of pairs, of points in balls and
    /// tiles and the least distance are the same to the last bit; sums over all points (spectrum, mean distance, errors
    /// of integrals) differ by their rounding. Measures of the first set alone are not made: it is too large.
    bool add(const PointStrips& points);

    /// True for a realization, by its number, that was added and is one of the sets before.
    bool is_repeated(std::size_t realization) const { return std::ranges::binary_search(repeated_, realization); }

    /// True if a set that was added here is one of `earlier` as well: append() does not take that.
    bool repeats(const SeriesAnalysis& earlier) const;

    /// The sets of `earlier` are not counted here: for a part that repeats them, before any is added.
    void leave_out(const SeriesAnalysis& earlier);

    /// Appends the realizations of `next`, which begins after the last one here; equal to adding them here, up to
    /// rounding: parts of the same sizes give the same bytes. Throws as add() does, and std::invalid_argument where
    /// `next` repeats a set.
    void append(const SeriesAnalysis& next);

    const AnalysisOptions& options() const { return options_; }

    /// True if the options ask for spectra.
    bool has_spectrum() const { return options_.spectrum.has_value(); }

    /// The mean of the periodograms; at least one set must have been added, and there must be spectra.
    Spectrum mean_spectrum() const;

    /// radial_statistics() of a mean spectrum of this series, with errors.
    std::vector<RadialBin> radial_curve(const Spectrum& mean) const;

    /// The mean pair correlation, up to four of the largest possible minimum distances in steps of a fiftieth of
    /// it; empty where a set has one point only.
    std::vector<PairCorrelationBin> pair_correlation() const;

    /// The mean number variance over the radius; empty where a set has a few points only.
    std::vector<NumberVarianceBin> number_variance() const;

    /// The curves of sets in a region; empty for others, and where sets have one point only. Measures random sets.
    std::vector<RegionCurveRow> region_curves() const;

    /// The picture of the first set in its region, see mark_picture.hpp; empty for others.
    const std::string& region_picture() const { return region_picture_; }

    /// The density over the tile, of tilings of the plane.
    std::optional<SquareImage> folded_density() const;

    /// The zone plate that sets in memory sample, with options.zone_plate.
    const ZonePlateAnalysis& zone_plate() const { return zone_plate_; }

    /// Adds the measures of the mean spectrum to the result.
    void measure_spectrum(const Spectrum& mean);

    /// Adds those of the first set alone, which take triangulations, and forgets the set. Touches nothing that the
    /// other functions do, and may run beside them once all sets were added.
    void measure_first();

    /// Sizes, distances, measures and seconds so far.
    Series result() const;

    /// Everything but the first set as bytes, which are read into an analysis that was constructed alike.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(begin_.points, dimension_, sets_, shell_powers_, repeated_, seconds_, has_pairs_);
        Measures of_first;
        of_first.numbers = numbers_of_first_;
        archive(measures_, of_first);
        numbers_of_first_ = of_first.numbers;
        if (!sets_.empty() && !has_started_) start();
        if (estimate_) archive(*estimate_);
        if (pairs_) archive(*pairs_);
        if (variance_) archive(*variance_);
        if (integration_) archive(*integration_);
        if (seams_) archive(*seams_);
        if (folded_) archive(*folded_);
        archive(region_picture_);
        if (options_.zone_plate) archive(zone_plate_);
        if (!region_) return;
        if constexpr (Archive::reads)
            region_->read(archive);
        else
            region_->write(archive);
    }

private:
    static constexpr std::size_t most_points_triangulated = 300'000;

    /// The measures of one set.
    struct SetMeasures
    {
        std::size_t points = 0;
        std::uint32_t realization = 0;
        SetMark mark;
        double min_distance = 0; ///< unit lengths; infinite for a set of one point
        double relative_radius = 0;
        double covered_fraction = 0;
        double lattice_share = 0;  ///< of tiled sets
        double window_radius = 0;  ///< relative, without wrapping, of sets that were made elsewhere
        double window_nearest = 0; ///< like mean_nearest, without wrapping, of the same
        std::uint64_t across = 0;  ///< pairs across the border that are closer than all inside, of the same
        double mean_nearest = 0;   ///< of the largest possible minimum distance; infinite for a set of one point
        double prefix_radius = 0;  ///< of sets in progressive order
        double radius_within = 0;  ///< within tiles, of tiled sets; infinite where no tile has two points
        std::vector<double> lattice_shells = {}; ///< lattice_shell_powers() of tiled sets
        std::vector<double> near_lattice = {};   ///< near_lattice_powers() of tiled sets

        template <class Archive>
        void serialize(Archive& archive)
        {
            archive(points, realization, mark, min_distance, relative_radius, covered_fraction, lattice_share,
                    mean_nearest, prefix_radius, radius_within, lattice_shells, near_lattice, window_radius,
                    window_nearest, across);
        }
    };

    template <class Points>
    bool add_set(const Points& points);
    template <class Points>
    SetMeasures measure_distances(const Points& points) const;
    NearestDistances distances(const PointSet& points, bool is_window) const;
    NearestDistances distances(const PointStrips& points, bool is_window) const;
    bool finds_border() const { return options_.is_foreign && !options_.window && !options_.region; }
    template <class Points>
    void measure_border(const Points& points, SetMeasures& set) const;
    template <class Points>
    void measure_order(const Points& points, SetMeasures& set) const;
    void keep_first(const PointSet& points);
    void keep_first(const PointStrips& /*points*/) {}
    std::uint32_t next_realization() const;
    bool is_known(const SetMark& mark) const;
    BorderResult border_result() const;
    std::vector<std::size_t> independent_groups(std::size_t curves_of_set = 1) const;
    CurveErrors curve_errors(const std::vector<RadialBin>& radial) const;
    bool has_tapers() const { return region_ && region_->tapers() > 0; }
    std::size_t curves_of_set() const { return has_tapers() ? region_->tapers() : 1; }
    std::optional<Statistic> statistic(double SetMeasures::*member) const;
    Estimate mean_of(double SetMeasures::*member) const;
    double least_distance(const PointSet& points) const;
    double prefix_radius(const PointSet& points) const;
    void check(int dimension, std::size_t points, std::size_t realization) const;
    void start();
    void start_spectrum();
    void add_to_spectrum(const PointSet& points);
    void add_to_spectrum(const PointStrips& points) { estimate_->add(points); }
    void start_pairs();
    void leave_out_pairs();
    bool reaches_as_asked() const;
    void measure_whole(const std::vector<RadialBin>& radial, const Spectrum& mean);
    void measure_hyperuniformity(const Spectrum& mean);
    void measure_exponent_error(const std::vector<PowerShell>& shells, int realizations, double least);
    void measure_errors(std::vector<RadialBin> radial, const Spectrum& mean);
    void measure_lattice_errors();
    void measure_peak_error(const std::vector<RadialBin>& radial, const Spectrum& mean);

    std::string label_;
    bool sizes_vary_;
    AnalysisOptions options_;
    PeriodicBox box_; ///< of these options
    Begin begin_;
    bool has_started_ = false;
    std::vector<SetMeasures> sets_;                    ///< each another one
    std::vector<std::vector<double>> shell_powers_;    ///< of each set, those that the hyperuniformity exponent is of
    std::vector<std::size_t> repeated_;                ///< realizations that are one of these
    std::vector<SetMark> left_out_;                    ///< sets of earlier parts
    Measures measures_;                                ///< as far as they are known
    std::map<std::string, Estimate> numbers_of_first_; ///< beside measures_.numbers: threads may add to both at a time
    double seconds_ = 0;                               ///< that all of this took
    int spectrum_size_ = 0;                            ///< 0: no spectrum
    bool has_pairs_ = false;                           ///< sets of one point have none
    int dimension_ = 0;                                ///< of the first set; 0: there is none
    std::optional<SpectrumEstimate> estimate_;
    PointSet first_; ///< for measures of the first set alone
    std::optional<PairCorrelationEstimate> pairs_;
    std::optional<NumberVarianceEstimate> variance_;
    std::optional<IntegrationErrorEstimate> integration_;
    std::unique_ptr<RegionSeries> region_; ///< of sets in a region
    std::string region_picture_;
    ZonePlateAnalysis zone_plate_;
    std::optional<SeamDensity> seams_;    ///< of tilings
    std::optional<FoldedDensity> folded_; ///< of tilings of the plane
};

}
