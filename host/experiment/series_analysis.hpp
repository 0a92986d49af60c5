// What is measured on the realizations of a series, one after the other.
#pragma once

#include "analysis/radial_statistics.hpp"
#include "analysis/spectrum.hpp"
#include "experiment/experiment.hpp"

#include <optional>
#include <string>

namespace poissonlab {

/// Collects distances and adds up periodograms, in the order in which realizations come. The number of points
/// and the dimension of the first one decide the size of the spectrum.
class SeriesAnalysis
{
public:
    /// `label` is for messages; `sizes_vary` as the sampler says it.
    SeriesAnalysis(std::string label, bool sizes_vary, PeriodogramMethod method)
        : label_(std::move(label)), sizes_vary_(sizes_vary), method_(method)
    {}

    /// Throws InputError for sets that are empty, of another dimension, or of another size where sizes must
    /// not vary.
    void add(const PointSet& points);

    /// The mean of the periodograms; at least one set must have been added.
    Spectrum mean_spectrum() const;

    /// radial_statistics() of a mean spectrum of this series, with errors.
    std::vector<RadialBin> radial_curve(const Spectrum& mean) const;

    /// Adds the measures that are made from the radial curve to the result.
    void measure_spectrum(const std::vector<RadialBin>& radial);

    /// Sizes, distances and seconds so far, and the spectrum's size.
    const SeriesResult& result() const { return result_; }

private:
    void measure_first(const PointSet& points);

    std::string label_;
    bool sizes_vary_;
    PeriodogramMethod method_;
    SeriesResult result_;
    std::optional<SpectrumEstimate> estimate_;
};

}
