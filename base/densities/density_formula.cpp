#include "base/densities/density_formula.hpp"

#include "base/densities/density_values.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

namespace poissonlab {
namespace {

/// The parser knows assignments, which would change x and y: an equals sign that is no part of a comparison.
bool has_assignment(const std::string& formula)
{
    for (std::size_t i = 0; i < formula.size(); ++i) {
        if (formula[i] != '=') continue;
        const bool ends_comparison = i > 0 && std::string_view("=<>!").find(formula[i - 1]) != std::string_view::npos;
        const bool begins_comparison = i + 1 < formula.size() && formula[i + 1] == '=';
        if (!ends_comparison && !begins_comparison) return true;
    }
    return false;
}

std::string formula_name(const std::string& formula) { return fmt::format("formula \"{}\"", shortened(formula)); }

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
    double x = 0, y = 0;
    const std::string name = formula_name(formula);
    if (has_assignment(formula)) throw InputError(name + ": has an assignment; == compares");
    try {
        mu::Parser parser;
        parser.DefineVar("x", &x);
        parser.DefineVar("y", &y);
        parser.DefineConst("pi", std::numbers::pi);
        parser.DefineConst("e", std::numbers::e);
        parser.SetExpr(formula_of(formula));
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                x = (2 * column + 1 - columns) / static_cast<double>(std::max(columns, rows));
                y = (2 * row + 1 - rows) / static_cast<double>(std::max(columns, rows));
                values.push_back(parser.Eval());
            }
    } catch (const mu::Parser::exception_type& error) {
        throw InputError(fmt::format("{}: {}", name, printable(error.GetMsg())));
    }
    return {columns, rows, std::move(values)};
}

Density density_of_formula(const std::string& formula, double width, double height)
{
    const PixelValues values = formula_values(formula, width, height);
    return density_of_values(values.width, values.height, values.values, formula_name(formula));
}

}
