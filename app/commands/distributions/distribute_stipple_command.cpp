// poissonlab distribute stipple, distribute hatch: a picture in dots or strokes.
#include "app/commands/kind_options.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/ink/plot.hpp"
#include "host/distribution/place_file.hpp"
#include "host/distribution/runs/run_numbers.hpp"
#include "host/distribution/stipple.hpp"
#include "host/kinds/kinds.hpp"
#include "reports/drawings/mark_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace poissonlab {
namespace {

constexpr auto distribute_stipple_notes =
    R"help(Dots of one size, as many as the picture has ink: ink is 1 - luminance in linear light, or a formula in x and y from
-1 to 1 with values from 0, white, to 1, black. Number times area of the dots is the ink, exactly, in the picture and,
as evenly as they lie, in each part, as long as they do not overlap. What is said of the tones: the ink beyond which
dots of this size overlap even where it is constant, how many pixels have more, how much ink lies on other ink, and the
mean difference from the picture over windows of 32 pixels. Photographs have darker parts than dots can print: --ink 0.5
prints half of the ink everywhere.
--by says how dots find their places:
  gaussian     even points are warped, and then adaptive Gaussian blue noise (Ahmed, Ren, Wonka 2022) makes them even at
               every tone, in --iterations steps; the truest tones. Fewer than 135 dots are only warped.
  warping      even points through the inverse cumulative distribution (distribute warp): fast, but it stretches
               distances, which shows as clumps and bands
  ranks        points of the lowest ranks: of the self-similar tile (distribute rank), or, with --tiles, of a ranked tile
               set, whose dots do not overlap at all where no pixel is too dark; fast
For 12,800 dots the tone error after a blur by one distance of dots is, in percent of the mean ink: gaussian 1.5 to 2.1,
warping 3.9 to 10.6, ranks with tiles 6.3 to 8.4 (a ramp, a lit ball, a photograph of a forest); after a blur by four
distances 0.5 to 0.9, 0.8 to 5.4 and 1.1 to 2.1. All of it takes 2.7, 0.9 and 0.7 s of a processor.
--out, as often as you like: .svg has all dots, .png shows how much of each pixel is covered, encoded as sRGB, so that
a screen shows the ink that is asked for (--pixels wide, by default as the picture), .dxf has them as circles (release
12), other files have their middles, in units of the longest side, y upwards.
For plotters and cutters --width 200mm (or cm, in) makes .svg and .dxf files whose picture is that wide; the sheet is
wider by a dot's diameter (a stroke's length) on each side, for dots that reach beyond the picture, so that pictures of
one size with the same --dot have equal sheets. Dots are circles, as large as they print, or with --pen 0.3mm such that
the pen's outer edge is the dot's, or with --dots strokes lines of 0.01 mm, which the pen makes dots of. Marks come in the
order of a short way, always the nearest one that is left, unless --travel as-made keeps the sampler's order; both ways are
said. Without any of these options an .svg has dots as lines of no length, which is the shortest file and what plotters'
programs drop.
  poissonlab distribute stipple --image photo.jpg --points 40000 --out dots.svg --out dots.png
  poissonlab distribute stipple --image photo.jpg --points 5000 --width 200mm --pen 0.5mm --out plot.svg
  poissonlab distribute stipple --image photo.jpg --dot 3 --ink 0.5 --out dots.ply --json)help";

constexpr auto distribute_hatch_notes =
    R"help(Strokes of one size with round ends instead of dots: see `help distribute stipple` for ink, tones and files. Strokes
are --slenderness times as long as wide, and lie along the picture's lines (its smoothed structure tensor), where it has
none at 45 degrees, or all at --angle. Long strokes overlap sooner than dots: what is said of the tones counts it.
  poissonlab distribute hatch --image photo.jpg --points 13000 --ink 0.5 --out strokes.svg
  poissonlab distribute hatch --image photo.jpg --stroke 1.5 --angle 0.8 --out strokes.png --pixels 2048)help";

/// Width and height of a .png.
std::array<int, 2> png_size(const KindOptions& o, const InkPicture& picture)
{
    if (o.pixels == 0) return {picture.ink.width, picture.ink.height};
    const auto wide = static_cast<int>(o.pixels);
    const double high = std::round(static_cast<double>(picture.ink.height) * wide / picture.ink.width);
    if (high > max_drawing_pixels)
        throw InputError(
            fmt::format("--pixels {}: the picture would be {} pixels high; must be at most 32768", wide, high));
    return {wide, std::max(1, static_cast<int>(high))};
}

bool has_file(const KindOptions& o, const std::string& ending)
{
    return std::ranges::any_of(o.outs.files(), [&](const auto& file) { return file.extension() == ending; });
}

/// Throws InputError where options for plotters have no file to go to, before any work is done.
void check_plot(const KindOptions& o, const StippleSettings& settings)
{
    if (!settings.plot || has_file(o, ".svg") || has_file(o, ".dxf")) return;
    throw InputError(
        fmt::format("{}: --{}: needs an --out that ends in .svg or .dxf", o.command(), settings.plot->option));
}

void write_marks(const KindOptions& o, const StippleSettings& settings, const InkPicture& picture,
                 const Stippling& stippling)
{
    const auto [wide, high] = png_size(o, picture);
    std::optional<Plot> plot;
    if (settings.plot || has_file(o, ".dxf"))
        plot = plot_of(stippling.marks, picture.ink.width, picture.ink.height, stippling.margin,
                       settings.plot.value_or(PlotSheet{}));
    if (plot && !o.is_quiet()) fmt::print(o.prints_json() ? stderr : stdout, "{}\n", plot_words(*plot));
    for (const std::filesystem::path& file : o.outs.files()) {
        if (file.extension() == ".svg" && settings.plot)
            write_whole_file(file, plot_svg(*plot));
        else if (file.extension() == ".svg")
            write_whole_file(file, drawing_svg(draw_marks(mark_picture(picture, stippling), {})));
        else if (file.extension() == ".dxf")
            write_whole_file(file, plot_dxf(*plot, o.command_comment("marks")));
        else if (file.extension() == ".png")
            write_coverage(file,
                           coverage_of(stippling.marks, wide, high, static_cast<double>(wide) / picture.ink.width));
        else
            write_places(file, stippling.places,
                         static_cast<std::uint32_t>(std::max(picture.ink.width, picture.ink.height)),
                         o.command_comment(fmt::format(
                             "{} middles of marks in units of the longest side of {} x {} pixels, y upwards",
                             stippling.places.size() / 2, picture.ink.width, picture.ink.height)));
    }
}

void say_tones(const KindOptions& o, bool has_strokes, const TonesOfMarks& tones, const Stippling& stippling)
{
    const std::size_t count = stippling.places.size() / 2;
    if (o.is_quiet()) return;
    fmt::print("{} {}, {:.3g} pixels {}; tone error {:.4f} over windows of 32 pixels\n", count,
               has_strokes ? "strokes" : "dots", stippling.mark_width, has_strokes ? "wide" : "in diameter",
               tones.error);
    fmt::print("{:.1f} % of the pixels are too dark: they have more ink than {:.3f}, where {} overlap; {:.2f} % of the "
               "ink lies on other ink{}\n",
               100 * tones.too_dark, tones.darkest_ink, has_strokes ? "strokes can" : "dots", 100 * tones.overlap,
               tones.too_dark > 0 && !has_strokes ? "; a smaller --ink prints them right" : "");
}

void stipple_picture(const KindOptions& o)
{
    const auto settings = o.read<StippleSettings>();
    check_plot(o, settings);
    const InkPicture picture = read_ink(settings);
    o.say_note(picture.ink.note);
    if (settings.by == MarkPlaces::ranks && settings.method.tiles.empty())
        o.say_note(
            fmt::format("--by ranks without --tiles takes the ranks of the self-similar tile, {}; tiles made by tiles "
                        "build --ranked show none",
                        lattice_words));
    const DistributionPlace place = o.place();
    const Stippling stippling = stipple(picture, settings, o.seed(), place);
    const Coverage coverage = coverage_of(stippling.marks, picture.ink.width, picture.ink.height, 1);
    write_marks(o, settings, picture, stippling);
    const TonesOfMarks tones = tones_of(picture, settings, stippling, coverage, place);
    if (!o.prints_json()) return say_tones(o, settings.has_strokes, tones, stippling);
    DistributionNumbers numbers = mark_numbers(picture, settings, stippling, tones);
    numbers.insert(numbers.begin(),
                   {"marks", "Marks", static_cast<double>(stippling.places.size()) / 2, "in the picture"});
    print_numbers(numbers);
}

Command mark_command(const char* word, const char* notes)
{
    return kind_command(*find_kind("distribution", word), {{{".svg", ".png", ".dxf"}, true}}, notes, stipple_picture,
                        "", {max_drawing_pixels, "the picture's"});
}
}

Command distribute_stipple_command() { return mark_command("stippling", distribute_stipple_notes); }
Command distribute_hatch_command() { return mark_command("hatching", distribute_hatch_notes); }

}
