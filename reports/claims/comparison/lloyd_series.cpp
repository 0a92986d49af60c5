#include "reports/claims/comparison/lloyd_series.hpp"

namespace poissonlab {
namespace {

bool starts_with(const ReportSeries& series, const std::string& sampler)
{
    for (const auto& [key, value] : series.stored->parameters)
        if (key == "start") return value.starts_with(sampler);
    return sampler == "random"; // the default
}

}

std::vector<const ReportSeries*> lloyd_of_darts(const ClaimSeries& report, SeriesQuery::Needs needs, int dimension)
{
    auto found = report.all({.sampler = "lloyd", .dimension = dimension, .needs = needs});
    std::erase_if(found, [](const ReportSeries* series) {
        return text_parameter(*series, "repulsion") == "true" || !starts_with(*series, "dart-throwing");
    });
    return found;
}

}
