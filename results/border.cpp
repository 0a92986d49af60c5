#include "results/border.hpp"

#include "analysis/borders/border_pairs.hpp"
#include "results/series.hpp"

#include <fmt/format.h>

namespace poissonlab {

bool BorderResult::is_not_periodic() const { return chance < least_chance_across; }

std::string border_words(const Series& series)
{
    if (!series.border || !series.border->is_not_periodic()) return {};
    const BorderResult& border = *series.border;
    return fmt::format(
        "The closest pairs of points meet across the border ({} pairs are closer than any two inside): the "
        "sets are not periodic, and are measured as if they were. Without wrapping, the relative radius "
        "is {:.3f} and the mean nearest distance {:.3f}.",
        border.pairs_across, border.relative_radius, border.mean_nearest_distance);
}

std::string border_advice(int dimension)
{
    return fmt::format("To measure them within the {}: poissonlab analyze --periodic no; in a config {}; in Python "
                       "periodic=False. If they are periodic: --periodic yes, periodic=True.",
                       dimension == 2 ? "square" : "cube",
                       dimension == 2 ? "region = \"rectangle 0 0 1 1\" in the [[method]]"
                                      : "window = true under [analysis]");
}

}
