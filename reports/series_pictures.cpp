#include "reports/series_pictures.hpp"

#include "analysis/spectrum_file.hpp"
#include "analysis/zone_plate_file.hpp"
#include "errors/errors.hpp"
#include "io/point_file.hpp"
#include "io/whole_file.hpp"
#include "reports/grey_image.hpp"
#include "reports/pair_correlation_table.hpp"
#include "reports/plane_image.hpp"
#include "reports/radial_table.hpp"
#include "reports/spectrum_image.hpp"
#include "reports/zone_plate_image.hpp"
#include "reports/zone_plate_table.hpp"

#include <fmt/format.h>

namespace poissonlab {

void read_curves(ReportSeries& series)
{
    const auto& stored = *series.stored;
    auto& curve = series.curve;
    curve.label = series.label;
    curve.points = stored.points;
    curve.dimension = series.run->dimension;
    curve.bins = read_radial_table(series.run->folder / stored.radial_file);
    curve.background_db = stored.background_anisotropy_db;
    curve.realizations = stored.realizations;
    if (stored.min_distance && stored.min_distance->mean > 0)
        curve.principal_frequency = 1 / stored.min_distance->mean;
    curve.max_frequency = stored.spectrum_size > 0 ? stored.spectrum_size / 2 : curve.bins.back().frequency;
    if (!stored.pair_correlation_file.empty())
        series.pair_correlation = read_pair_correlation_table(series.run->folder / stored.pair_correlation_file);
    if (stored.zone_plate)
        series.zone_plate = read_zone_plate_table(series.run->folder / stored.zone_plate->error_file);
}

void draw_points_pictures(ReportSeries& series)
{
    const auto file = series.run->folder / series.stored->point_files.front();
    const auto sets = read_points(file);
    const std::size_t points = series.stored->points_of_first();
    if (sets.empty() || sets.front().size() != points || sets.front().dimension != series.run->dimension)
        throw InputError(file.string() + ": must hold " + std::to_string(points) + " points with " +
                         std::to_string(series.run->dimension) + " coordinates, as results.json says");
    series.view = choose_points_view(sets.front());
    write_png(series.pictures / "points.png", draw_points(series.view));
    write_whole_file(series.pictures / "points.svg", points_svg(series.view));
}

void draw_spectrum_picture(const ReportSeries& series)
{
    if (series.stored->spectrum_file.empty()) return;
    const auto file = series.run->folder / series.stored->spectrum_file;
    const auto planes = read_spectrum_planes(file);
    const int size = planes.front().size;
    const std::size_t expected = series.run->dimension == 2 ? 1 : 3;
    if (size != series.stored->spectrum_size || planes.size() != expected)
        throw InputError(fmt::format("{}: must be {} of {} x {}, as results.json says", file.string(),
                                     expected == 1 ? "an image" : "images of three planes",
                                     series.stored->spectrum_size, series.stored->spectrum_size));
    const auto draw = [&](int block) {
        return expected == 1 ? draw_spectrum(planes.front(), report_tone_mapping, block)
                             : draw_spectrum_planes(planes, report_tone_mapping, block);
    };
    write_png(series.pictures / "spectrum.png", draw(1));
    write_png(series.pictures / "spectrum-small.png", draw(spectrum_page_block(size, series.run->dimension)));
}

void draw_zone_plate_picture(const ReportSeries& series)
{
    if (!series.stored->zone_plate) return;
    const auto& stored = *series.stored->zone_plate;
    const auto file = series.run->folder / stored.file;
    const auto image = read_zone_plate(file);
    if (image.size != stored.size)
        throw InputError(fmt::format("{}: must be an image of {} x {}, as results.json says", file.string(),
                                     stored.size, stored.size));
    write_png(series.pictures / "zone-plate.png", draw_zone_plate(image));
}

}
