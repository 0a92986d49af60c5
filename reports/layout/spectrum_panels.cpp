// The pictures of spectra: the plane, or planes and the cube of a 3D one.
// The pictures that show where points are in relation to one another, and to their tiles.
#include "analysis/spectra/autocorrelation.hpp"
#include "analysis/spectra/spectrum_file.hpp"
#include "reports/images/spectrum_image.hpp"
#include "reports/layout/series_panels.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using SpectrumPart = SpectrumPicture::Part;

SpectrumPicture picture(const ReportSeries& series, SpectrumPart part)
{
    const auto& stored = *series.stored;
    return {series.run->folder / stored.spectrum_file, stored.spectrum_size, series.run->dimension, part,
            stored.box ? stored.box->box() : PeriodicBox{}};
}

std::string caption(const ReportSeries& series)
{
    const Series& stored = *series.stored;
    const int size = stored.spectrum_size;
    const auto side = format_count(static_cast<std::uint64_t>(size));
    const bool in_space = series.run->dimension == 3;
    const std::size_t tapers = stored.region ? stored.region->tapers : 0;
    auto text = stored.is_estimate ? fmt::format("Mean of {} periodograms of", stored.realizations)
                                   : std::string("Of one set,");
    if (tapers > 0)
        text = fmt::format("Mean over {} tapers of the region", tapers) +
               (stored.realizations > 1 ? fmt::format(" and {} sets,", stored.realizations) : " of one set,");
    text += fmt::format(" {} × {} frequencies", side, in_space ? side + " × " + side : side);
    if (stored.box)
        text += fmt::format(": those that all directions have, up to {} in cycles per root of the {}",
                            format_significant(spectrum_reach(stored), 3), in_space ? "box's volume" : "box's area");
    else if (in_space)
        text += fmt::format(": the planes through frequency 0, from {} to {} along each axis",
                            format_fixed(-size / 2, 0), format_fixed(size / 2 - 1, 0));
    if (const int block = spectrum_page_block(size, series.run->dimension); block > 1)
        text += fmt::format("; a pixel here is the mean of {0} × {0}, or the highest of them above 20, and a larger "
                            "picture is one click away",
                            block);
    return text + ".";
}

std::string close_ups_caption(const Series& stored, int reach)
{
    if (stored.box)
        return fmt::format("The middle of the planes through frequency 0, up to {} along each axis.",
                           format_significant(reach * spectrum_reach(stored) / (stored.spectrum_size / 2), 3));
    return fmt::format("The middle of the planes through frequency 0, from {} to {}.", format_fixed(-reach, 0),
                       format_fixed(reach - 1, 0));
}

std::string guide(bool in_space)
{
    std::string text =
        "The grey at each frequency is the power of the set there; frequency 0 is in the centre. A good blue noise set "
        "has a dark disk in the centre, an even ring around it, and even grey beyond. Spikes reveal a grid or a "
        "period, "
        "and rays reveal preferred directions.";
    if (in_space)
        text +=
            " In 3D the pictures are the three planes through the centre, named by their axes: they cut a dark ball "
            "and its shell.";
    return text;
}

}

std::vector<int> spectrum_slices(int spectrum_size)
{
    std::vector<int> frequencies;
    for (const PlanePlace& place : shown_planes(spectrum_size))
        if (place.frequency > 0) frequencies.push_back(place.frequency);
    return frequencies;
}

void add_spectrum_panel(const ReportSeries& series, std::vector<Panel>& panels)
{
    const auto& stored = *series.stored;
    if (stored.spectrum_file.empty()) return;
    Panel panel{.stem = "spectrum",
                .picture = picture(series, SpectrumPart::whole),
                .title = stored.is_estimate ? "Power spectrum estimate" : "Periodogram",
                .caption = caption(series),
                .guide = guide(series.run->dimension == 3),
                .stored = {{"exr", series.run->folder / stored.spectrum_file}},
                .thumbnail = Thumbnail{"spectrum", "Spectrum"},
                .image_class = "framed"};
    if (!stored.volume_file.empty()) panel.stored.push_back({"volume exr", series.run->folder / stored.volume_file});
    panels.push_back(std::move(panel));
}

void add_space_panels(const ReportSeries& series, std::vector<Panel>& panels)
{
    const auto& stored = *series.stored;
    if (series.run->dimension == 2 || stored.spectrum_file.empty()) return;
    const int reach = std::max(1, 5 * stored.spectrum_size / 16);
    const Panel close_ups{.stem = "spectrum-close-ups",
                          .picture = picture(series, SpectrumPart::close_ups),
                          .title = "Close-ups",
                          .caption = close_ups_caption(stored, reach),
                          .image_class = "",
                          .figure_class = "row"};
    if (stored.box) return panels.push_back(close_ups); // a cube of frequencies has sides that do not differ
    panels.push_back({.stem = "spectrum-cube",
                      .picture = picture(series, SpectrumPart::cube),
                      .title = "Cube of frequencies",
                      .caption =
                          "x to the lower left, y to the lower right, z upwards; the eighth where all are positive "
                          "is cut away down to frequency 0.",
                      .image_class = ""});
    if (const auto slices = spectrum_slices(stored.spectrum_size); !slices.empty())
        panels.push_back({.stem = "spectrum-slices",
                          .picture = picture(series, SpectrumPart::slices),
                          .title = "Slices",
                          .caption = fmt::format("Planes where the frequency along z is {}.", fmt::join(slices, ", ")),
                          .image_class = "",
                          .figure_class = "row"});
    panels.push_back(close_ups);
}

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
