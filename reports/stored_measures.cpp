#include "reports/stored_measures.hpp"

#include <algorithm>

namespace poissonlab {

StoredMeasures read_measures(const StoredObject& series)
{
    StoredMeasures measures;
    if (!series.has("measures")) return measures;
    const auto object = series.object("measures");
    if (object.has("effective_nyquist")) measures.effective_nyquist = object.number("effective_nyquist");
    if (object.has("oscillation")) {
        const auto oscillation = object.object("oscillation");
        measures.oscillation = {oscillation.number("value"), oscillation.number("noise_floor")};
    }
    if (object.has("low_frequency_power")) {
        const auto fit = object.object("low_frequency_power");
        measures.low_frequency_power = {fit.number("exponent"), fit.number("exponent_standard_error"),
                                        fit.number("intercept"), fit.number("intercept_standard_error")};
    }
    if (object.has("largest_empty"))
        measures.largest_empty_radius = object.object("largest_empty").number("relative_radius");
    if (object.has("voronoi")) {
        const auto cells = object.object("voronoi");
        const auto shares = cells.numbers("neighbour_share");
        measures.voronoi.emplace();
        if (shares.size() != measures.voronoi->neighbour_share.size())
            throw cells.error("neighbour_share", "must be five numbers");
        measures.voronoi->relative_area_variance = cells.number("relative_area_variance");
        std::ranges::copy(shares, measures.voronoi->neighbour_share.begin());
    }
    return measures;
}

}
