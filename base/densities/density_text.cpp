#include "base/densities/density_text.hpp"

#include "base/densities/density_values.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {

Density density_of_text(const std::string& text, const std::string& from, double width, double height)
{
    if (is_file_name(text)) return density_of_picture(read_linear_picture(text), from, text);
    if (from != "light")
        throw InputError(
            fmt::format("{}: \"{}\" is for pictures, and this is not a picture", shortened(text), printable(from)));
    try {
        return density_of_formula(text, width, height);
    } catch (const InputError& error) {
        throw formula_error(text, error);
    }
}

std::string formula_of(const std::string& name_or_text)
{
    if (name_or_text == "gauss-and-waves") return "exp(-20*(x^2+y^2)) + 0.05*sin(pi*x)^2*sin(pi*y)^2";
    return name_or_text;
}

PixelValues formula_values(const std::string& formula, double width, double height)
{
    const double longest = std::max(width, height);
    const auto pixels = [&](double side) {
        return std::max(1, static_cast<int>(std::lround(formula_pixels * side / longest)));
    };
    const int columns = pixels(width), rows = pixels(height);
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    PlaneFormula plane(formula);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            values.push_back(plane.at((2 * column + 1 - columns) / static_cast<double>(std::max(columns, rows)),
                                      (2 * row + 1 - rows) / static_cast<double>(std::max(columns, rows))));
    return {columns, rows, std::move(values)};
}

Density density_of_formula(const std::string& formula, double width, double height)
{
    const PixelValues values = formula_values(formula, width, height);
    return density_of_values(values.width, values.height, values.values, PlaneFormula(formula).name());
}

}
