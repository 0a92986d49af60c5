#include "host/measuring/zone_plate_analysis.hpp"

#include "analysis/zone_plate/zone_plate.hpp"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace poissonlab {

void ZonePlateAnalysis::add(const PointSet& points)
{
    const auto begin = std::chrono::steady_clock::now();
    SquareImage image = zone_plate_image(points);
    const PlateError error = error_.add(image);
    result_.rms_error.push_back(error.whole);
    result_.resolved_rms_error.push_back(error.resolved);
    if (first_.size == 0) {
        result_.size = image.size;
        first_ = std::move(image);
    }
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void ZonePlateAnalysis::append(const ZonePlateAnalysis& other)
{
    const auto append_to = [](std::vector<double>& values, const std::vector<double>& more) {
        values.insert(values.end(), more.begin(), more.end());
    };
    error_.append(other.error_);
    append_to(result_.rms_error, other.result_.rms_error);
    append_to(result_.resolved_rms_error, other.result_.resolved_rms_error);
    if (first_.size == 0) {
        result_.size = other.result_.size;
        first_ = other.first_;
    }
    seconds_ += other.seconds_;
}

std::string ZonePlateAnalysis::csv() const
{
    std::string text = "distance,frequency,rms_error,pixels\n";
    for (const ErrorBin& bin : error_.curve())
        text += fmt::format("{},{},{},{}\n", bin.distance, bin.frequency, bin.rms_error, bin.pixels);
    return text;
}

}
