#include "results/measures.hpp"

#include <algorithm>

namespace poissonlab {

namespace {

// Pictures are called after it.
std::string read_integrand(const StoredObject& integral)
{
    const auto name = integral.text("integrand");
    const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
    if (name.empty() || !std::ranges::all_of(name, is_letter))
        throw integral.error("integrand", "must be small letters");
    return name;
}

std::optional<double> optional_number(const StoredObject& object, const std::string& name)
{
    if (!object.has(name)) return std::nullopt;
    return object.number(name);
}

}

Measures read_measures(const StoredObject& series)
{
    Measures measures;
    if (!series.has("measures")) return measures;
    const auto object = series.object("measures");
    measures.effective_nyquist = optional_number(object, "effective_nyquist");
    measures.effective_nyquist_error = optional_number(object, "effective_nyquist_standard_error");
    if (object.has("oscillation")) {
        const auto oscillation = object.object("oscillation");
        measures.oscillation = {oscillation.number("value"), oscillation.number("noise_floor"),
                                optional_number(oscillation, "standard_error")};
    }
    if (object.has("low_frequency_power")) {
        const auto fit = object.object("low_frequency_power");
        measures.low_frequency_power = {fit.number("exponent"), fit.number("exponent_standard_error"),
                                        fit.number("intercept"), fit.number("intercept_standard_error")};
    }
    if (object.has("lattice_peaks")) {
        const auto peaks = object.object("lattice_peaks");
        measures.lattice_peaks = {peaks.integer("tiles", 2), peaks.number("max_ratio"), peaks.number("mean_ratio"),
                                  peaks.integer("peaks", 0), optional_number(peaks, "mean_ratio_standard_error")};
    }
    if (object.has("peak_anisotropy")) {
        const auto peak = object.object("peak_anisotropy");
        measures.peak_anisotropy = {peak.number("db"), peak.number("frequency"),
                                    optional_number(peak, "standard_error_db"), peak.integer("samples", 1)};
    }
    if (object.has("integration"))
        for (const auto& integral : object.objects("integration"))
            measures.integration.push_back({read_integrand(integral), integral.number("rms_error"),
                                            integral.number("standard_error"), integral.number("relative_variance")});
    if (object.has("largest_empty"))
        measures.largest_empty_radius = object.object("largest_empty").number("relative_radius");
    if (object.has("voronoi")) {
        const auto cells = object.object("voronoi");
        const auto shares = cells.numbers("neighbour_share");
        measures.voronoi = Measures::Cells{};
        if (shares.size() != measures.voronoi->neighbour_share.size())
            throw cells.error("neighbour_share", "must be five numbers");
        measures.voronoi->relative_area_variance = cells.number("relative_area_variance");
        std::ranges::copy(shares, measures.voronoi->neighbour_share.begin());
    }
    return measures;
}

}
