#include "app/commands/tiles/window_density.hpp"

#include "base/densities/density_text.hpp"
#include "base/densities/density_values.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

constexpr auto option = "tiles points: --density";

}

WindowDensity::WindowDensity(const std::string& text, const std::string& from, const DensityArea& area, int dimension,
                             bool is_quiet)
    : area_(area)
{
    if (from != "light" && !is_file_name(text))
        throw InputError(fmt::format("tiles points: --density-from {}: is for pictures, and --density {} is none",
                                     printable(from), shortened(text)));
    if (const auto number = is_file_name(text) ? std::nullopt : constant_of(text)) {
        if (!(*number > 0 && *number <= 1))
            throw InputError(fmt::format("{} {}: must be a number greater than 0 and at most 1, a picture or a formula",
                                         option, text));
        number_ = *number;
        return;
    }
    if (dimension != 2)
        throw InputError(fmt::format("{} {}: must be a number for tiles in space", option, shortened(text)));
    try {
        density_ = density_of_text(text, from, area.size[0], area.size[1]);
        if (!density_->note.empty() && !is_quiet) fmt::print(stderr, "poissonlab: note: {}\n", density_->note);
    } catch (const UnknownChannel& error) {
        throw InputError(fmt::format("tiles points: --density-from: {}", error.what()));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

}
