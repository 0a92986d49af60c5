#include "reports/claims/claim_series.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace poissonlab {

namespace {

bool fits(const ReportSeries& series, SeriesQuery::Needs needs)
{
    switch (needs) {
    case SeriesQuery::Needs::spectrum:
        return !series.curve.bins.empty() && (series.stored->realizations > 1 || series.stored->deterministic);
    case SeriesQuery::Needs::plate:
        return series.stored->zone_plate.has_value();
    case SeriesQuery::Needs::iterations:
        return series.stored->iterations.has_value();
    case SeriesQuery::Needs::anything:
        break;
    }
    return true;
}

bool fits(const ReportSeries& series, const SeriesQuery& query)
{
    if (series.stored->sampler != query.sampler || series.run->dimension != query.dimension) return false;
    if (query.points) {
        const auto n = static_cast<double>(series.stored->points), asked = static_cast<double>(*query.points);
        if (std::abs(n - asked) > 0.1 * asked) return false;
    }
    const bool parameters = std::ranges::all_of(query.numbers, [&](const auto& parameter) {
        const auto value = number_parameter(series, parameter.first);
        return value && std::abs(*value - parameter.second) < 1e-9;
    });
    return parameters && fits(series, query.needs);
}

}

std::optional<double> ClaimSeries::scheme_number(const std::string& kind, const std::string& key) const
{
    for (const DistributionResult* scheme : distributions(kind))
        if (const auto number = number_of(*scheme, key)) return number;
    return std::nullopt;
}

ClaimSeries::ClaimSeries(std::vector<const ReportSeries*> series, std::vector<const DistributionResult*> distributions)
    : series_(std::move(series)), distributions_(std::move(distributions))
{
    // Papers speak of the torus, or of the plane.
    std::erase_if(series_, [](const ReportSeries* one) { return one->stored->region.has_value(); });
    rings_ = rings_in_plates(series_);
}

bool ClaimSeries::has_tiles() const
{
    return !distributions_.empty() || std::ranges::any_of(series_, [](const ReportSeries* series) {
        const std::string& sampler = series->stored->sampler;
        return sampler.ends_with("-tiles") || sampler == "penrose" || sampler == "polyominoes";
    });
}

std::vector<const DistributionResult*> ClaimSeries::distributions(const std::string& kind) const
{
    std::vector<const DistributionResult*> found;
    std::ranges::copy_if(distributions_, std::back_inserter(found),
                         [&](const DistributionResult* distribution) { return distribution->kind == kind; });
    return found;
}

std::optional<double> number_of(const DistributionResult& distribution, const std::string& key)
{
    const auto found = std::ranges::find(distribution.numbers, key, &DistributionNumber::key);
    if (found == distribution.numbers.end()) return std::nullopt;
    return found->value;
}

std::optional<Estimate> estimate_in(const DistributionResult& distribution, const std::string& key)
{
    const auto found = std::ranges::find(distribution.numbers, key, &DistributionNumber::key);
    if (found == distribution.numbers.end()) return std::nullopt;
    return Estimate{found->value, found->standard_error};
}

void ClaimSeries::note(const SeriesQuery& query) const
{
    if (std::ranges::find(asked_, query.sampler) == asked_.end()) asked_.push_back(query.sampler);
}

std::vector<const ReportSeries*> ClaimSeries::all(const SeriesQuery& query) const
{
    note(query);
    std::vector<const ReportSeries*> found;
    std::ranges::copy_if(series_, std::back_inserter(found), [&](const auto* series) { return fits(*series, query); });
    return found;
}

const ReportSeries* ClaimSeries::one(const SeriesQuery& query) const
{
    note(query);
    const auto found = std::ranges::find_if(series_, [&](const auto* series) { return fits(*series, query); });
    return found == series_.end() ? nullptr : *found;
}

std::optional<ClaimSeries::Rings> ClaimSeries::false_rings(const ReportSeries& series) const
{
    const auto found = rings_.find(&series);
    return found == rings_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<double> number_parameter(const ReportSeries& series, const std::string& key)
{
    for (const NamedTexts* values : {&series.stored->parameters, &series.stored->defaults}) {
        const auto found = std::ranges::find(*values, key, &NamedTexts::value_type::first);
        if (found == values->end()) continue;
        double value = 0;
        const char* const last = found->second.data() + found->second.size();
        const auto [end, error] = std::from_chars(found->second.data(), last, value);
        return error == std::errc() && end == last ? std::optional(value) : std::nullopt;
    }
    return std::nullopt;
}

std::string text_parameter(const ReportSeries& series, const std::string& key)
{
    for (const NamedTexts* texts : {&series.stored->parameters, &series.stored->defaults})
        for (const auto& [name, value] : *texts)
            if (name == key) return value;
    return {};
}

std::optional<double> tiles_of_set(const ReportSeries& series)
{
    const auto& sampler = series.stored->sampler;
    if (sampler == "template-tiles") return number_parameter(series, "tiles");
    const auto colors = number_parameter(series, "colors");
    if (!colors) return std::nullopt;
    if (sampler == "corner-tiles") return std::pow(*colors, 4);
    if (sampler == "edge-tiles") return std::pow(*colors, 12);
    if (sampler == "sphere-tiles") return std::pow(*colors, 8);
    return std::nullopt;
}

const Estimate* estimate_of(const ReportSeries& series, const std::string& key)
{
    const auto& numbers = series.stored->measures.numbers;
    const auto found = numbers.find(key);
    return found == numbers.end() ? nullptr : &found->second;
}

bool has_estimated_spectrum(const ReportSeries& series)
{
    return !series.curve.bins.empty() && (series.stored->realizations > 1 || series.stored->deterministic);
}

double plate_error(const ReportSeries& series, double low, double high)
{
    double squares = 0, pixels = 0;
    for (const auto& bin : series.zone_plate) {
        if (bin.frequency < low || bin.frequency >= high) continue;
        squares += bin.rms_error * bin.rms_error * static_cast<double>(bin.pixels);
        pixels += static_cast<double>(bin.pixels);
    }
    return pixels > 0 ? std::sqrt(squares / pixels) : 0;
}

int tile_sets_of(const ReportSeries& series) { return static_cast<int>(number_parameter(series, "sets").value_or(1)); }

}
