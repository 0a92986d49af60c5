// Formulas in x and y, of densities and of regions.
#pragma once

#include <memory>
#include <string>

namespace poissonlab {

class PlaneFormula
{
public:
    /// The formula of a name or a text, see formula_of(). Throws InputError, one line with the text, where it assigns
    /// something: that would change x and y.
    explicit PlaneFormula(const std::string& name_or_text);
    ~PlaneFormula();
    PlaneFormula(const PlaneFormula&) = delete;
    PlaneFormula& operator=(const PlaneFormula&) = delete;

    /// The value at a place. Throws InputError, one line with the text, where the formula cannot be understood.
    double at(double x, double y);

    /// The text as messages call it.
    const std::string& name() const { return name_; }

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
    std::string name_;
};

}
