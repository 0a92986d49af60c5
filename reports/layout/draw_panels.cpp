#include "reports/layout/draw_panels.hpp"

#include "analysis/spectra/autocorrelation.hpp"
#include "analysis/spectra/spectrum_file.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/grey_image.hpp"
#include "base/images/square_image.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/drawings/mark_image.hpp"
#include "reports/drawings/points_image.hpp"
#include "reports/images/cube_image.hpp"
#include "reports/images/spectrum_image.hpp"
#include "reports/images/zone_plate_image.hpp"
#include "reports/layout/series_panels.hpp"
#include "reports/layout/thumbnails.hpp"
#include "reports/plots/gnuplot_text.hpp"
#include "reports/plots/plot_thumbnail.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

constexpr int thumbnail_size = 256; // pixels
constexpr int points_pixels = 1024;
constexpr int cells_pixels = 1024;
constexpr int density_pixels = 512;

/// The planes through frequency 0; others cannot stand beside each other in one picture.
std::vector<Spectrum> in_true_proportion(const std::vector<Spectrum>& planes, const SpectrumPicture& picture)
{
    const auto share = [&](std::size_t axis) { return picture.box.sides[axis] / picture.box.longest(); };
    if (picture.dimension == 2) return {in_true_proportion(planes.front(), share(0), share(1))};
    return {in_true_proportion(planes.at(0), share(0), share(1)), in_true_proportion(planes.at(1), share(0), share(2)),
            in_true_proportion(planes.at(2), share(1), share(2))};
}

/// The number of frequencies along each axis for which a pixel of a stored spectrum stands.
int stored_block(const SpectrumPicture& picture, const Spectrum& stored)
{
    return picture.dimension == 2 ? picture.size / std::max(1, stored.size) : 1;
}

/// The planes that results.json promises: one of a 2D spectrum, which may be of means over blocks, several of a 3D one.
std::vector<Spectrum> read_planes(const SpectrumPicture& picture)
{
    auto planes = read_spectrum_planes(picture.file);
    const bool in_space = picture.dimension == 3;
    const int size = planes.front().size;
    const int size_of_means = in_space ? 0 : picture.size / block_for(picture.size, largest_stored_spectrum);
    if ((size != picture.size && size != size_of_means) ||
        planes.size() != (in_space ? shown_planes(picture.size).size() : 1))
        throw InputError(fmt::format("{}: must be {} of {} x {}, as results.json says", picture.file.string(),
                                     in_space ? "images of a 3D spectrum's planes" : "an image", picture.size,
                                     picture.size));
    return picture.box.is_unit() ? planes : in_true_proportion(planes, picture);
}

void write_in_pixels(const fs::path& path, const Drawing& drawing)
{
    write_drawing_png(path, drawing, static_cast<int>(drawing.width));
}

Drawing draw_slices(const std::vector<Spectrum>& planes)
{
    std::vector<Spectrum> shown;
    const auto places = shown_planes(planes.front().size);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i].frequency > 0) shown.push_back(planes[i]);
    return draw_plane_row(shown, {shown.size(), "xy"}, report_tone_mapping, page_block(planes.front().size));
}

Drawing draw_close_ups(const std::vector<Spectrum>& planes)
{
    std::vector<Spectrum> middles;
    for (std::size_t i = 0; i < 3; ++i) middles.push_back(spectrum_close_up(planes.at(i)));
    return draw_plane_row(middles, {"xy", "xz", "yz"}, report_tone_mapping);
}

/// The whole number of pixels for a small image's pixel.
int magnification(int size) { return std::max(1, density_pixels / size); }

/// A spectrum of means over blocks of b x b frequencies, which are b apart, is drawn as that of a torus with sides of 1
/// / b and the same density of points.
GreyImage draw_autocorrelation(Spectrum spectrum, int block)
{
    spectrum.points /= static_cast<std::size_t>(block) * static_cast<std::size_t>(block);
    const SquareImage image = autocorrelation(spectrum, autocorrelation_reach(spectrum.points));
    return draw_density(image, magnification(image.size));
}

/// The picture at full size, as the page shows it, and the thumbnail.
void draw_whole_spectrum(const SpectrumPicture& picture, const Panel& panel, const fs::path& folder)
{
    const auto planes = read_planes(picture);
    const int block = spectrum_page_block(planes.front().size, picture.dimension);
    if (picture.dimension == 3) {
        const auto draw = [&](int pixel) { return draw_spectrum_planes(planes, report_tone_mapping, pixel); };
        const Drawing shown = draw(block);
        write_in_pixels(folder / print_file(panel), block == 1 ? shown : draw(1));
        write_in_pixels(folder / shown_file(panel), shown);
        write_thumbnail(folder / thumbnail_file(panel), shown, 2 * thumbnail_size);
        return;
    }
    const auto draw = [&](int pixel) { return draw_spectrum(planes.front(), report_tone_mapping, pixel); };
    const GreyImage shown = draw(block);
    write_png(folder / print_file(panel), block == 1 ? shown : draw(1));
    write_png(folder / shown_file(panel), shown);
    write_png(folder / thumbnail_file(panel), draw(block * std::max(1, planes.front().size / block / thumbnail_size)));
}

void draw_spectrum_picture(const SpectrumPicture& picture, const Panel& panel, const fs::path& folder)
{
    using Part = SpectrumPicture::Part;
    if (picture.part == Part::whole) return draw_whole_spectrum(picture, panel, folder);
    const auto planes = read_planes(picture);
    const auto file = folder / print_file(panel);
    if (picture.part == Part::cube) write_png(file, draw_spectrum_cube(planes, report_tone_mapping));
    if (picture.part == Part::slices) write_in_pixels(file, draw_slices(planes));
    if (picture.part == Part::close_ups) write_in_pixels(file, draw_close_ups(planes));
    if (picture.part == Part::autocorrelation)
        write_png(file, draw_autocorrelation(planes.front(), stored_block(picture, planes.front())));
}

/// The image of a file, which results.json promises to have that size.
SquareImage read_image(const fs::path& file, int size)
{
    SquareImage image = read_square_image(file);
    if (image.size != size)
        throw InputError(
            fmt::format("{}: must be an image of {} x {}, as results.json says", file.string(), size, size));
    return image;
}

/// Draws a panel by the kind of its picture.
struct Draw
{
    const Panel& panel;
    const fs::path& folder;
    PictureStore& store;

    void operator()(const Plot& plot) const
    {
        if (panel.thumbnail) write_whole_file(folder / thumbnail_file(panel), drawing_svg(plot_thumbnail(plot)));
    }

    void operator()(const PointsView& view) const
    {
        const Drawing drawing = draw_points(view);
        const auto svg = write_drawing(folder / panel.stem, drawing, points_pixels, store);
        const auto thumbnail = folder / thumbnail_file(panel);
        store.draw_once({thumbnail}, svg, [&] { write_drawing_png(thumbnail, drawing, thumbnail_size); });
    }

    void operator()(const CellsView& view) const
    {
        write_drawing(folder / panel.stem, draw_cells(view), cells_pixels, store);
    }

    void operator()(const MarkPanel& marks) const
    {
        const Drawing drawing = draw_marks(read_mark_picture(marks.file), marks.file.parent_path());
        const auto svg = write_drawing(folder / panel.stem, drawing, points_pixels, store);
        const auto thumbnail = folder / thumbnail_file(panel);
        store.draw_once({thumbnail}, svg, [&] { write_drawing_png(thumbnail, drawing, thumbnail_size); });
    }

    void operator()(const SpectrumPicture& picture) const
    {
        std::vector<fs::path> files = {folder / print_file(panel), folder / shown_file(panel)};
        if (panel.thumbnail) files.push_back(folder / thumbnail_file(panel));
        const auto input = fmt::format("{} {}\n", picture.dimension, picture.size) + read_whole_file(picture.file);
        store.draw_once(files, input, [&] { draw_spectrum_picture(picture, panel, folder); });
    }

    void operator()(const ZonePlatePicture& picture) const
    {
        const auto input = fmt::format("{}\n", picture.size) + read_whole_file(picture.file);
        const auto png = folder / print_file(panel);
        const auto thumbnail = folder / thumbnail_file(panel);
        store.draw_once({png, thumbnail}, input, [&] {
            const GreyImage image = draw_zone_plate(read_image(picture.file, picture.size));
            write_png(png, image);
            write_thumbnail(thumbnail, drawing_of({image.width, image.height, 1, image.pixels}), thumbnail_size);
        });
    }

    void operator()(const DensityPicture& picture) const
    {
        const auto png = folder / print_file(panel);
        const auto input = fmt::format("density {}\n", picture.size) + read_whole_file(picture.file);
        store.draw_once({png}, input, [&] {
            write_png(png, draw_density(read_image(picture.file, picture.size), magnification(picture.size)));
        });
    }
};

}

void draw_panel(const Panel& panel, const fs::path& folder, PictureStore& store)
{
    std::visit(Draw{panel, folder, store}, panel.picture);
}

void add_plot(const Panel& panel, const fs::path& folder, std::vector<GnuplotPicture>& plots)
{
    if (const Plot* plot = panel.plot()) plots.push_back(gnuplot_picture(*plot, folder / panel.stem));
}

}
