// What is measured on the realizations of a series, one after the other.
#pragma once

#include "analysis/integration_error.hpp"
#include "analysis/pair_correlation.hpp"
#include "analysis/radial_statistics.hpp"
#include "analysis/spectrum.hpp"
#include "experiment/experiment.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Collects distances, and adds up periodograms, pair correlations and errors of integrals, in the order in which
/// realizations come. The number of points and the dimension of the first one decide the size of the spectrum.
///
/// With options.distances_only it leaves out what takes longest for large sets: pair correlation, errors of integrals,
/// packing, the largest empty ball and Voronoi cells.
class SeriesAnalysis
{
public:
    /// `label` is for messages; `sizes_vary` as the sampler says it.
    SeriesAnalysis(std::string label, bool sizes_vary, const AnalysisOptions& options)
        : label_(std::move(label)), sizes_vary_(sizes_vary), options_(options)
    {}

    /// Throws InputError for sets that are empty, of another dimension, or of another size where sizes must
    /// not vary.
    void add(const PointSet& points);

    /// Whether the options ask for spectra.
    bool has_spectrum() const { return options_.spectrum.has_value(); }

    /// The mean of the periodograms; at least one set must have been added, and there must be spectra.
    Spectrum mean_spectrum() const;

    /// radial_statistics() of a mean spectrum of this series, with errors.
    std::vector<RadialBin> radial_curve(const Spectrum& mean) const;

    /// The mean pair correlation, up to four of the largest possible minimum distances in steps of a fiftieth of
    /// it; empty where a set has one point only.
    std::vector<PairCorrelationBin> pair_correlation() const;

    /// Adds the measures of the mean spectrum to the result.
    void measure_spectrum(const Spectrum& mean);

    /// Adds those of the first set alone, which take triangulations. Touches nothing that the other functions do, and may
    /// run beside them once all sets were added.
    void measure_first();

    /// Sizes, distances and seconds so far, and the spectrum's size.
    const SeriesResult& result() const { return result_; }

private:
    void check(const PointSet& points) const;
    void start(const PointSet& first);
    void start_spectrum(const PointSet& first);
    void measure_errors(std::vector<RadialBin> radial, int dimension);

    std::string label_;
    bool sizes_vary_;
    AnalysisOptions options_;
    SeriesResult result_;
    int dimension_ = 0; ///< of the first set
    std::optional<SpectrumEstimate> estimate_;
    std::vector<double> peak_ratios_; ///< mean lattice peak of each realization
    PointSet first_;                  ///< for measures of the first set alone
    std::optional<PairCorrelationEstimate> pairs_;
    std::optional<IntegrationErrorEstimate> integration_;
};

}
