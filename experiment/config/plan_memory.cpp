#include "experiment/config/plan_memory.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

DeviceMemory memory_of(const SeriesPlan& series, std::size_t points, const DeviceInfo& device)
{
    SampleRequest request = series.request;
    request.points = points;
    return series.sampler->device_memory(series.parameters, request, device);
}

/// The largest number of points that fits, 0 for none. More points never need less memory.
std::size_t most_points_that_fit(const SeriesPlan& series, const DeviceInfo& device)
{
    std::size_t fitting = 0;
    for (std::size_t beyond = series.request.points; beyond - fitting > 1;) {
        const std::size_t middle = fitting + (beyond - fitting) / 2;
        (fits(memory_of(series, middle, device), device) ? fitting : beyond) = middle;
    }
    return fitting;
}

}

void check_device_memory(const std::vector<SeriesPlan>& plan, const DeviceInfo& device)
{
    for (const SeriesPlan& series : plan) {
        if (!series.sampler->device_memory) continue;
        const DeviceMemory memory = memory_of(series, series.request.points, device);
        if (fits(memory, device)) continue;
        const std::size_t most = most_points_that_fit(series, device);
        throw InputError::at(series.where, fmt::format("{}: {}{}", series.label, comparison(memory, device),
                                                       most > 0 ? fmt::format("; up to {} points would fit", most)
                                                                : "; fewer points would not fit either"));
    }
}

}
