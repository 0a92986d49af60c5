#include "base/densities/plane_formula.hpp"

#include "base/densities/density_formula.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <numbers>
#include <string_view>

namespace poissonlab {
namespace {

/// The parser knows assignments, which would change the coordinates: an equals sign that is no part of a comparison.
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

}

struct SpaceFormula::Parser
{
    mu::Parser parser;
    double x = 0, y = 0, z = 0;
};

SpaceFormula::SpaceFormula(const std::string& name_or_text, int axes)
    : parser_(std::make_unique<Parser>()), name_(fmt::format("formula \"{}\"", shortened(name_or_text)))
{
    if (has_assignment(name_or_text)) throw InputError(name_ + ": has an assignment; == compares");
    try {
        parser_->parser.DefineVar("x", &parser_->x);
        parser_->parser.DefineVar("y", &parser_->y);
        if (axes == 3) parser_->parser.DefineVar("z", &parser_->z);
        parser_->parser.DefineConst("pi", std::numbers::pi);
        parser_->parser.DefineConst("e", std::numbers::e);
        parser_->parser.SetExpr(formula_of(name_or_text));
    } catch (const mu::Parser::exception_type& error) {
        throw InputError(fmt::format("{}: {}", name_, printable(error.GetMsg())));
    }
}

SpaceFormula::~SpaceFormula() = default;

double SpaceFormula::at(double x, double y, double z)
{
    parser_->x = x;
    parser_->y = y;
    parser_->z = z;
    try {
        return parser_->parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
        throw InputError(fmt::format("{}: {}", name_, printable(error.GetMsg())));
    }
}

}
