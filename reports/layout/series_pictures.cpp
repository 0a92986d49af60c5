#include "reports/layout/series_pictures.hpp"

#include "analysis/spectra/spectrum_file.hpp"
#include "analysis/spectra/spectrum_planes.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/grey_image.hpp"
#include "base/images/square_image_file.hpp"
#include "base/points/point_file.hpp"
#include "reports/drawings/drawing_pictures.hpp"
#include "reports/images/cube_image.hpp"
#include "reports/images/plane_image.hpp"
#include "reports/images/spectrum_image.hpp"
#include "reports/images/zone_plate_image.hpp"
#include "reports/layout/thumbnails.hpp"
#include "results/pair_correlation_table.hpp"
#include "results/radial_table.hpp"
#include "results/zone_plate_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

constexpr int thumbnail_size = 256; // pixels
constexpr int points_pixels = 1024;
constexpr int cells_pixels = 1024;

}

void read_curves(ReportSeries& series)
{
    const auto& stored = *series.stored;
    auto& curve = series.curve;
    curve.label = series.label;
    curve.points = stored.points;
    curve.dimension = series.run->dimension;
    if (stored.has_spectrum()) curve.bins = read_radial_table(series.run->folder / stored.radial_file);
    curve.background_db = stored.background_anisotropy_db;
    curve.realizations = stored.realizations;
    if (stored.min_distance && stored.min_distance->mean > 0) curve.principal_frequency = 1 / stored.min_distance->mean;
    if (stored.spectrum_size > 0)
        curve.max_frequency = stored.spectrum_size / 2;
    else if (stored.has_spectrum())
        curve.max_frequency = curve.bins.back().frequency;
    if (!stored.pair_correlation_file.empty())
        series.pair_correlation = read_pair_correlation_table(series.run->folder / stored.pair_correlation_file);
    if (stored.zone_plate)
        series.zone_plate = read_zone_plate_table(series.run->folder / stored.zone_plate->error_file);
}

namespace {

void draw_cells_pictures(ReportSeries& series, const PointSet& points, PictureStore& store)
{
    if (points.dimension != 2) return;
    series.cells = choose_cells_view(points);
    write_drawing(series.pictures / "cells", draw_cells(*series.cells), cells_pixels, store);
}

}

void draw_points_pictures(ReportSeries& series, PictureStore& store)
{
    const auto file = series.run->folder / series.stored->point_files.front();
    const auto sets = read_points(file);
    const std::size_t points = series.stored->points_of_first();
    if (sets.empty() || sets.front().size() != points || sets.front().dimension != series.run->dimension)
        throw InputError(file.string() + ": must hold " + std::to_string(points) + " points with " +
                         std::to_string(series.run->dimension) + " coordinates, as results.json says");
    series.view = choose_points_view(sets.front());
    const Drawing drawing = draw_points(series.view);
    const auto svg = write_drawing(series.pictures / "points", drawing, points_pixels, store);
    const auto thumbnail = series.pictures / "points-thumbnail.png";
    store.draw_once({thumbnail}, svg, [&] { write_drawing_png(thumbnail, drawing, thumbnail_size); });
    draw_cells_pictures(series, sets.front(), store);
}

namespace {

// The planes that results.json promises: one of a 2D spectrum, several of a 3D one.
std::vector<Spectrum> read_planes(const ReportSeries& series)
{
    const auto file = series.run->folder / series.stored->spectrum_file;
    auto planes = read_spectrum_planes(file);
    const int size = series.stored->spectrum_size;
    const bool in_space = series.run->dimension == 3;
    if (planes.front().size != size || planes.size() != (in_space ? shown_planes(size).size() : 1))
        throw InputError(fmt::format("{}: must be {} of {} x {}, as results.json says", file.string(),
                                     in_space ? "images of a 3D spectrum's planes" : "an image", size, size));
    return planes;
}

void write_in_pixels(const std::filesystem::path& path, const Drawing& drawing)
{
    write_drawing_png(path, drawing, static_cast<int>(drawing.width));
}

// The coordinate planes, the cube, slices along z, and the middle of the coordinate planes.
void draw_space_spectra(const ReportSeries& series, const std::vector<Spectrum>& planes)
{
    const int block = page_block(planes.front().size), small_block = spectrum_page_block(planes.front().size, 3);
    write_in_pixels(series.pictures / "spectrum.png", draw_spectrum_planes(planes, report_tone_mapping));
    const Drawing small = draw_spectrum_planes(planes, report_tone_mapping, small_block);
    write_in_pixels(series.pictures / "spectrum-small.png", small);
    write_thumbnail(series.pictures / "spectrum-thumbnail.png", small, 2 * thumbnail_size);
    write_png(series.pictures / "spectrum-cube.png", draw_spectrum_cube(planes, report_tone_mapping));
    const auto slices = spectrum_slices(series);
    if (!slices.empty()) {
        const std::vector<Spectrum> shown(planes.end() - static_cast<std::ptrdiff_t>(slices.size()), planes.end());
        write_in_pixels(series.pictures / "spectrum-slices.png",
                        draw_plane_row(shown, {shown.size(), "xy"}, report_tone_mapping, block));
    }
    std::vector<Spectrum> middles;
    for (std::size_t i = 0; i < 3; ++i) middles.push_back(spectrum_close_up(planes.at(i)));
    write_in_pixels(series.pictures / "spectrum-close-ups.png",
                    draw_plane_row(middles, {"xy", "xz", "yz"}, report_tone_mapping));
}

}

std::vector<int> spectrum_slices(const ReportSeries& series)
{
    std::vector<int> frequencies;
    for (const PlanePlace& place : shown_planes(series.stored->spectrum_size))
        if (place.frequency > 0) frequencies.push_back(place.frequency);
    return frequencies;
}

namespace {

// A stored file's contents and what results.json says about it.
std::string stored_input(const ReportSeries& series, const std::string& file, int size)
{
    return fmt::format("{} {} {}\n", series.run->dimension, size, file) + read_whole_file(series.run->folder / file);
}

std::vector<std::filesystem::path> spectrum_files(const ReportSeries& series)
{
    std::vector<std::string> names = {"spectrum.png", "spectrum-small.png", "spectrum-thumbnail.png"};
    if (series.run->dimension == 3) {
        names.insert(names.end(), {"spectrum-cube.png", "spectrum-close-ups.png"});
        if (!spectrum_slices(series).empty()) names.emplace_back("spectrum-slices.png");
    }
    std::vector<std::filesystem::path> files;
    for (const auto& name : names) files.push_back(series.pictures / name);
    return files;
}

void draw_spectra(const ReportSeries& series)
{
    const auto planes = read_planes(series);
    if (series.run->dimension == 3) return draw_space_spectra(series, planes);
    const int size = series.stored->spectrum_size, block = page_block(size);
    const int small_block = block * std::max(1, size / block / thumbnail_size);
    const auto draw = [&](int pixel) { return draw_spectrum(planes.front(), report_tone_mapping, pixel); };
    write_png(series.pictures / "spectrum.png", draw(1));
    write_png(series.pictures / "spectrum-small.png", draw(block));
    write_png(series.pictures / "spectrum-thumbnail.png", draw(small_block));
}

}

void draw_spectrum_pictures(const ReportSeries& series, PictureStore& store)
{
    const auto& stored = *series.stored;
    if (stored.spectrum_file.empty()) return;
    store.draw_once(spectrum_files(series), stored_input(series, stored.spectrum_file, stored.spectrum_size),
                    [&] { draw_spectra(series); });
}

void write_radial_thumbnail(const ReportSeries& series, const CurveScales& scales)
{
    if (!series.stored->has_spectrum()) return;
    write_whole_file(series.pictures / "radial-thumbnail.svg",
                     drawing_svg(draw_radial_thumbnail(series.curve, scales)));
}

void draw_zone_plate_picture(const ReportSeries& series, PictureStore& store)
{
    if (!series.stored->zone_plate) return;
    const auto& stored = *series.stored->zone_plate;
    const auto png = series.pictures / "zone-plate.png";
    const auto thumbnail = series.pictures / "zone-plate-thumbnail.png";
    store.draw_once({png, thumbnail}, stored_input(series, stored.file, stored.size), [&] {
        const auto file = series.run->folder / stored.file;
        const auto image = read_square_image(file);
        if (image.size != stored.size)
            throw InputError(fmt::format("{}: must be an image of {} x {}, as results.json says", file.string(),
                                         stored.size, stored.size));
        const auto picture = draw_zone_plate(image);
        write_png(png, picture);
        write_thumbnail(thumbnail, drawing_of({picture.width, picture.height, 1, picture.pixels}), thumbnail_size);
    });
}

}
