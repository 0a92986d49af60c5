// The sampling test on the realizations of a series, one after the other.
#pragma once

#include "analysis/zone_plate/zone_plate_error.hpp"
#include "results/series.hpp"

#include <vector>

namespace poissonlab {

/// Throws MissingModule if this program was built without the zone plate. Long work that will sample it calls this
/// function first.
void need_zone_plate();

/// Samples the zone plate with each realization, keeps the first picture, and compares all with the
/// reference.
class ZonePlateAnalysis
{
public:
    /// `points` must be 2D and not empty, as SeriesAnalysis demands it.
    void add(const PointSet& points);

    /// Appends the realizations of `other`; equal to adding them here.
    void append(const ZonePlateAnalysis& other);

    /// The picture of the first realization.
    const SquareImage& first_image() const { return first_; }

    /// The error over the distance, of all realizations.
    std::vector<ErrorBin> curve() const { return error_.curve(); }

    ZonePlateResult result() const;
    double seconds() const { return seconds_; }

    /// All members as bytes.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(first_.size, first_.pixels, error_, rms_errors_, resolved_rms_errors_, seconds_);
    }

private:
    SquareImage first_;
    ZonePlateError error_;
    std::vector<double> rms_errors_; ///< of each realization
    std::vector<double> resolved_rms_errors_;
    double seconds_ = 0;
};

}
