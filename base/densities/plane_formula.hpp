// Formulas in x and y, and in x, y and z, of densities and of regions.
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace poissonlab {

class SpaceFormula
{
public:
    /// The formula of a name or a text, see formula_of(). Throws InputError, one line with the text, where it cannot be
    /// understood, is several formulas with commas between them, or assigns something: that would change x, y and z.
    explicit SpaceFormula(const std::string& name_or_text) : SpaceFormula(name_or_text, 3) {}
    ~SpaceFormula();
    SpaceFormula(const SpaceFormula&) = delete;
    SpaceFormula& operator=(const SpaceFormula&) = delete;

    /// The value at a place.
    double at(double x, double y, double z);

    /// True where the value is the same everywhere, as no coordinate occurs.
    bool is_constant() const;

    /// The text as messages call it.
    const std::string& name() const { return name_; }

protected:
    SpaceFormula(const std::string& name_or_text, int axes);

private:
    struct Parser;
    std::unique_ptr<Parser> parser_;
    std::string name_;
};

/// A formula in x and y alone.
class PlaneFormula : SpaceFormula
{
public:
    explicit PlaneFormula(const std::string& name_or_text) : SpaceFormula(name_or_text, 2) {}

    double at(double x, double y) { return SpaceFormula::at(x, y, 0); }
    using SpaceFormula::is_constant;
    using SpaceFormula::name;
};

/// The number that a text is ("nan" and "inf" as well), or that a formula without x and y gives, such as "1/2". Nothing
/// for any other text.
std::optional<double> constant_of(const std::string& text);

}
