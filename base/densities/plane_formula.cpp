#include "base/densities/plane_formula.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/text/decimal_commas.hpp"

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

InputError error_in_formula(const std::string& name, const std::string& text, const mu::Parser::exception_type& error)
{
    return InputError(fmt::format("{}: {}{}", name, printable(error.GetMsg()), decimal_comma_words(text)));
}

}

struct SpaceFormula::Parser
{
    mu::Parser parser;
    double x = 0, y = 0, z = 0;
    bool is_constant = false;
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
        // A comma between formulas is one more result, of which Eval() would give the last one.
        int results = 0;
        parser_->parser.Eval(results);
        if (results != 1)
            throw InputError(fmt::format("{}: is {} formulas with commas between them: must be one{}", name_, results,
                                         decimal_comma_words(name_or_text)));
        parser_->is_constant = parser_->parser.GetUsedVar().empty();
    } catch (const mu::Parser::exception_type& error) {
        throw error_in_formula(name_, name_or_text, error);
    }
}

SpaceFormula::~SpaceFormula() = default;

double SpaceFormula::at(double x, double y, double z)
{
    parser_->x = x;
    parser_->y = y;
    parser_->z = z;
    return parser_->parser.Eval(); // throws no more: the text has been understood, and division by 0 is infinite
}

bool SpaceFormula::is_constant() const { return parser_->is_constant; }

std::optional<double> constant_of(const std::string& text)
{
    if (double number = 0; parse_number(text, number)) return number; // "nan" and "inf" as well, which no formula knows
    try {
        PlaneFormula formula(text);
        if (formula.is_constant()) return formula.at(0, 0);
    } catch (const InputError&) {
        // Whoever needs a formula says what is wrong with it.
    }
    return std::nullopt;
}

}
