// The pictures that show where points are in relation to one another, and to their tiles.
#include "analysis/spectra/autocorrelation.hpp"
#include "reports/layout/series_panels.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {

namespace {

constexpr double spacings_shown = 16;

}

double autocorrelation_reach(std::size_t points)
{
    return std::min(0.5, spacings_shown / std::sqrt(static_cast<double>(points)));
}

void add_autocorrelation_panel(const ReportSeries& series, std::vector<Panel>& panels)
{
    const auto& stored = *series.stored;
    if (series.run->dimension != 2 || stored.spectrum_file.empty() || stored.is_window || stored.region || stored.box ||
        stored.points < 2)
        return;
    const double reach = autocorrelation_reach(stored.points_of_first());
    panels.push_back(
        {.stem = "autocorrelation",
         .picture = SpectrumPicture{series.run->folder / stored.spectrum_file, stored.spectrum_size, 2,
                                    SpectrumPicture::Part::autocorrelation},
         .title = "Autocorrelation",
         .caption = fmt::format("Pairs of points by the displacement between them, up to {} along each axis: black no "
                                "pairs, mid-grey as many as random points have, white twice as many and more.",
                                format_significant(reach, 2)),
         .guide =
             "The pair correlation by direction as well as distance, which is the Fourier transform of the spectrum. "
             "A good set has a black disk in the centre, and rings that fade quickly into even grey, equally in "
             "all directions. Bright dots far from the centre are displacements at which points appear again: "
             "tiles that repeat.",
         .image_class = "framed"});
}

void add_folded_density_panel(const ReportSeries& series, std::vector<Panel>& panels)
{
    const auto& folded = series.stored->folded_density;
    if (!folded) return;
    panels.push_back(
        {.stem = "folded-density",
         .picture = DensityPicture{series.run->folder / folded->file, folded->size},
         .title = "Density over the tile",
         .caption = fmt::format("The points of all tiles in one, in {0} × {0} bins: black none, mid-grey the mean "
                                "density, white twice as many and more.",
                                folded->size),
         .guide =
             "In a good set of tiles the grey is even but for noise: the density does not depend on the place in a "
             "tile. Lines along the borders are seams; single light and dark bins are points that many tiles share.",
         .stored = {{"exr", series.run->folder / folded->file}},
         .image_class = "framed"});
}

}
