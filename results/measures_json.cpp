// The member "measures" of a series in results.json: what is not there was not defined for its sets.
#include "base/files/json_members.hpp"
#include "results/measures.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {

void members(JsonMembers& m, Stored<Oscillation> auto& oscillation)
{
    m.member("value", oscillation.value);
    m.or_none("begin", oscillation.begin);
    m.or_none("end", oscillation.end);
    m.member("standard_error", oscillation.standard_error);
}

void members(JsonMembers& m, Stored<PeakAnisotropy> auto& peak)
{
    m.member("db", peak.db);
    m.member("frequency", peak.frequency);
    m.member("samples", peak.samples, 1);
    m.member("standard_error_db", peak.standard_error_db);
    m.if_any("power", peak.power);
}

void members(JsonMembers& m, Stored<LowFrequencyPower> auto& power)
{
    m.member("exponent", power.exponent);
    m.member("exponent_standard_error", power.exponent_standard_error);
    m.member("intercept", power.intercept);
    m.member("intercept_standard_error", power.intercept_standard_error);
    m.or_none("begin", power.begin);
    m.or_none("end", power.end);
}

void members(JsonMembers& m, Stored<LatticePeaks> auto& peaks)
{
    m.member("tiles", peaks.tiles, 2);
    m.member("max_ratio", peaks.max_ratio);
    m.member("mean_ratio", peaks.mean_ratio);
    m.or_none("frequency", peaks.frequency);
    m.member("peaks", peaks.peaks);
    m.member("mean_ratio_standard_error", peaks.mean_ratio_standard_error);
}

void members(JsonMembers& m, Stored<IntegrationError> auto& error)
{
    m.member("integrand", error.integrand);
    m.or_none("integral", error.integral);
    m.member("rms_error", error.rms_error);
    m.member("standard_error", error.standard_error);
    m.member("relative_variance", error.relative_variance);
    m.check([&](const StoredObject& object) { // pictures are called after it
        const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
        if (error.integrand.empty() || !std::ranges::all_of(error.integrand, is_letter))
            throw object.error("integrand", "must be small letters");
    });
}

void members(JsonMembers& m, Stored<LargestEmptyBall> auto& ball)
{
    m.or_none("radius", ball.radius);
    m.member("relative_radius", ball.relative_radius);
}

void members(JsonMembers& m, Stored<VoronoiStatistics> auto& cells)
{
    m.member("relative_area_variance", cells.relative_area_variance);
    m.member("neighbour_share", cells.neighbour_share);
}

namespace {

std::string error_member(const std::string& key) { return key + "_standard_error"; }

void numbers(JsonMembers& m, const std::map<std::string, Estimate>& numbers)
{
    for (const auto& [key, number] : numbers) {
        if (!measure(key).is_number) throw std::logic_error(key + " is not a single number in the catalogue");
        m.member(key, number.value);
        m.member(error_member(key), number.standard_error);
    }
}

void numbers(JsonMembers& m, std::map<std::string, Estimate>& numbers)
{
    for (const Measure& measure : measures())
        if (measure.is_number && m.stored().has(measure.key)) {
            m.member(measure.key, numbers[measure.key].value);
            m.member(error_member(measure.key), numbers[measure.key].standard_error);
        }
}

void describe(JsonMembers& m, Stored<Measures> auto& measures)
{
    numbers(m, measures.numbers);
    m.object("oscillation", measures.oscillation);
    m.object("peak_anisotropy", measures.peak_anisotropy);
    m.object("low_frequency_power", measures.low_frequency_power);
    m.object("lattice_peaks", measures.lattice_peaks);
    m.objects_if_any("integration", measures.integration);
    m.object("largest_empty", measures.largest_empty);
    m.object("voronoi", measures.voronoi);
}

}

void members(JsonMembers& m, const Measures& measures) { describe(m, measures); }
void members(JsonMembers& m, Measures& measures) { describe(m, measures); }

std::string measures_text(const Measures& measures)
{
    return json_text([&](JsonMembers& m) { members(m, measures); });
}

Measures read_measures(const std::string& text)
{
    Measures measures;
    read_unplaced(text, "measures", [&](JsonMembers& m) { members(m, measures); });
    return measures;
}

}
