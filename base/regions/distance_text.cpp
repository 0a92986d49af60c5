// Distances that users type: pictures and formulas.
#include "base/densities/density_text.hpp"
#include "base/densities/density_values.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/files/file_kind.hpp"
#include "base/images/linear_picture.hpp"
#include "base/regions/distance_field.hpp"

#include <algorithm>
#include <memory>

namespace poissonlab {
namespace {

/// Bilinear between middles of pixels; beyond the outer ones as these. `x` and `y` are parts of the sides, from 0 to 1.
double value_between(const PixelValues& pixels, double x, double y)
{
    struct Between
    {
        int low, high;
        double part;
    };
    const auto between = [](double part, int count) -> Between {
        const double at = std::clamp(part * count - 0.5, 0.0, static_cast<double>(count - 1));
        const int low = std::min(static_cast<int>(at), std::max(0, count - 2));
        return {low, std::min(low + 1, count - 1), at - low};
    };
    const Between column = between(x, pixels.width), row = between(y, pixels.height);
    const auto along = [&](int y_of) {
        return pixels.at(column.low, y_of) * (1 - column.part) + pixels.at(column.high, y_of) * column.part;
    };
    return along(row.low) * (1 - row.part) + along(row.high) * row.part;
}

}

DistanceAt distance_of_text(const std::string& text, const std::string& from, const std::array<double, 2>& range,
                            const RegionBox& box)
{
    if (is_file_name(text)) {
        const auto pixels = std::make_shared<const PixelValues>(picture_values(read_linear_picture(text), from, text));
        return [pixels, range, box](double x, double y) {
            const double value =
                value_between(*pixels, (x - box.low[0]) / box.width(), (y - box.low[1]) / box.height());
            return range[0] + (range[1] - range[0]) * value;
        };
    }
    try {
        const auto formula = std::make_shared<PlaneFormula>(text);
        formula->at(box.low[0], box.low[1]);
        return [formula](double x, double y) { return formula->at(x, y); };
    } catch (const InputError& error) {
        throw formula_error(text, error);
    }
}

}
