#include "base/densities/density_text.hpp"

#include "base/densities/density_formula.hpp"
#include "base/densities/density_values.hpp"
#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"

#include <fmt/format.h>

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

}
