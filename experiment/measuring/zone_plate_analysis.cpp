#include "experiment/measuring/zone_plate_analysis.hpp"

#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "results/file_names.hpp"

#include <chrono>
#include <utility>

namespace poissonlab {

void need_zone_plate() {}

void ZonePlateAnalysis::add(const PointSet& points)
{
    const auto begin = std::chrono::steady_clock::now();
    SquareImage image = zone_plate_image(points);
    const PlateError error = error_.add(image);
    rms_errors_.push_back(error.whole);
    resolved_rms_errors_.push_back(error.resolved);
    if (first_.size == 0) first_ = std::move(image);
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void ZonePlateAnalysis::append(const ZonePlateAnalysis& other)
{
    const auto append_to = [](std::vector<double>& values, const std::vector<double>& more) {
        values.insert(values.end(), more.begin(), more.end());
    };
    error_.append(other.error_);
    append_to(rms_errors_, other.rms_errors_);
    append_to(resolved_rms_errors_, other.resolved_rms_errors_);
    if (first_.size == 0) first_ = other.first_;
    seconds_ += other.seconds_;
}

ZonePlateResult ZonePlateAnalysis::result() const
{
    return {first_.size, file_names::zone_plate, file_names::zone_plate_error,
            statistic_of(rms_errors_).value_or(Statistic{}), statistic_of(resolved_rms_errors_)};
}

}
